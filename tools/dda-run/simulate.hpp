#pragma once

#include <optional>
#include <string>

#include "command_line.hpp"
#include "folder_lock.hpp"

namespace rockslope {

/// The program's exit codes.
enum ExitCode { done = 0, analysis_failed = 1, bad_input = 2, stopped = 75 };

/// Reads the input, runs the simulation and writes all results. @return the exit code; a failure of the
/// analysis is reported on stderr. @throws InputError before any result is changed, OutputError when a result
/// cannot be written.
/// @param lock of the output folder; taken once there is that folder where there was none.
ExitCode simulate(const CommandLine& line, const std::string& version, std::optional<FolderLock>& lock);

}  // namespace rockslope
