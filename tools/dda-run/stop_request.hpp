#pragma once

#include <filesystem>

namespace rockslope {

/// After this call SIGINT, SIGTERM and SIGHUP request a stop; another signal, two seconds later or more, ends
/// the program at once. A write beyond the file-size limit becomes a write error instead of a signal.
void install_signal_handlers();

/// True after a signal, or when `stop_file` exists; removes the file.
bool stop_requested(const std::filesystem::path& stop_file);

}  // namespace rockslope
