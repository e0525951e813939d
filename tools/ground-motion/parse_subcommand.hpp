#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rockslope {

/// Parses the arguments of a subcommand, or prints the text about it that they ask for: then nothing is
/// returned. Positional arguments are stored under "file". @param usage name and synopsis of the subcommand,
/// a line break, and its purpose. @throws InputError without the program's name.
std::optional<boost::program_options::variables_map> parse_subcommand(
    const std::string& usage, const std::vector<std::string>& arguments,
    const boost::program_options::options_description& options);

/// The positional arguments of a subcommand.
std::vector<std::string> files_of(const boost::program_options::variables_map& values);

}  // namespace rockslope
