#pragma once

#include <filesystem>

namespace rockslope {

/// From here on SIGINT, SIGTERM and SIGHUP ask for a stop instead of ending the program, and a full file-size
/// limit is an error of the write instead of a signal. A second one of them ends the program at once.
void install_signal_handlers();

/// True once a signal has come or `stop_file` exists; the file is removed, having said its word.
bool stop_requested(const std::filesystem::path& stop_file);

}  // namespace rockslope
