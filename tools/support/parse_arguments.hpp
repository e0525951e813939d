#pragma once

#include <boost/program_options.hpp>
#include <string>
#include <vector>

namespace rockslope::tool_support {

/// Parses arguments by options. Positional arguments are stored, as strings, under "file". Option names must
/// not be abbreviated. @param program the name that the error message begins with; empty: none.
/// @throws InputError with one line; for an unknown option it suggests the nearest one.
boost::program_options::variables_map parse_arguments(
    const std::string& program, const std::vector<std::string>& arguments,
    const boost::program_options::options_description& options);

/// The same for the arguments of main().
boost::program_options::variables_map parse_arguments(
    const char* program, int argc, const char* const* argv,
    const boost::program_options::options_description& options);

/// The arguments of main() without the program's name.
std::vector<std::string> arguments_of(int argc, const char* const* argv);

/// The model file of a command line parsed by parse_arguments(). @param usage synopsis for the error message.
/// @throws InputError when there is no model file, or more than one.
std::string model_file_of(const char* program, const boost::program_options::variables_map& values,
                          const std::string& usage);

}  // namespace rockslope::tool_support
