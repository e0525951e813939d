#pragma once

#include <boost/program_options.hpp>
#include <string>

namespace rockslope::tool_support {

/// Parses a command line by options. Positional arguments are stored, as strings, under "file". Option names
/// must not be abbreviated. @throws InputError with one line that begins with the program's name.
boost::program_options::variables_map parse_arguments(
    const char* program, int argc, const char* const* argv,
    const boost::program_options::options_description& options);

/// The model file of a command line parsed by parse_arguments(). @param usage synopsis for the error message.
/// @throws InputError when there is no model file, or more than one.
std::string model_file_of(const char* program, const boost::program_options::variables_map& values,
                          const std::string& usage);

}  // namespace rockslope::tool_support
