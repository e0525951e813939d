#pragma once

#include <boost/program_options.hpp>
#include <string>

namespace rockslope::tool_support {

/// The one model file of a command line read by parse_arguments(). @param usage how the program is called.
/// @throws InputError when there is none, or more than one.
std::string model_file_of(const char* program, const boost::program_options::variables_map& values,
                          const std::string& usage);

}  // namespace rockslope::tool_support
