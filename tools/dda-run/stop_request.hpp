#pragma once

#include <filesystem>

namespace rockslope {

/// After this call SIGINT, SIGTERM and SIGHUP request a stop; another one, two seconds later or more, ends
/// the program at once. SIGUSR1, SIGUSR2, SIGXCPU, SIGALRM and SIGVTALRM request a stop however often they
/// come. A signal that was ignored before stays so. A write beyond the file-size limit becomes a write error
/// instead of a signal.
void install_signal_handlers();

/// True after a signal, or when `stop_file` exists; removes the file.
bool stop_requested(const std::filesystem::path& stop_file);

}  // namespace rockslope
