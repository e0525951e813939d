#pragma once

#include <string>
#include <vector>

namespace rockslope {

/// `ground-motion synthesise`: makes an artificial accelerogram, writes it, and prints what an engineer would
/// check.
/// @param arguments of the command line after the subcommand. @returns the exit code.
/// @throws boost::program_options::error, std::invalid_argument for bad arguments; OutputError.
int run_synthesise(const std::vector<std::string>& arguments);

}  // namespace rockslope
