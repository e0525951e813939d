#pragma once

#include <string>

#include "command_line.hpp"

namespace rockslope {

/// The program's exit codes.
enum ExitCode { done = 0, analysis_failed = 1, bad_input = 2, stopped = 75 };

/// Reads the input, runs the simulation and writes all results. @return the exit code; a failure of the
/// analysis is reported on stderr. @throws InputError before any result is changed, OutputError when a result
/// cannot be written.
ExitCode simulate(const CommandLine& line, const std::string& version);

}  // namespace rockslope
