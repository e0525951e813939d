#pragma once

#include <string>
#include <vector>

namespace rockslope {

/// `ground-motion plot`: draws one record or several into one picture.
int run_plot(const std::vector<std::string>& arguments);

/// `ground-motion amplification`: how much more one point moved than another, in peaks and spectra.
int run_amplification(const std::vector<std::string>& arguments);

/// `ground-motion compare`: how far a measured point went in several runs, as a table and a picture.
int run_compare(const std::vector<std::string>& arguments);

// All: @param arguments of the command line after the subcommand. @returns the exit code.
// @throws boost::program_options::error, std::invalid_argument for bad arguments; InputError, OutputError.

}  // namespace rockslope
