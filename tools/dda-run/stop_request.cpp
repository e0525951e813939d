#include "stop_request.hpp"

#include <unistd.h>

#include <csignal>
#include <ctime>

namespace rockslope {

namespace {

volatile std::sig_atomic_t signalled = 0;
volatile std::time_t first_signal = 0;  // s; it is set before `signalled`

/// Signals of the same second or the next are one request: of a signal to its whole group, make sends its own
/// on to its children, which then get two.
constexpr std::time_t one_request = 1;  // s

void request_stop(int) {
    if (signalled == 0) {
        first_signal = std::time(nullptr);
        signalled = 1;
    }
}

/// Ends the program where a stop has been requested before.
void request_stop_or_end(int number) {
    if (signalled != 0 && std::time(nullptr) - first_signal > one_request) {
        std::signal(number, SIG_DFL);
        std::raise(number);
    }
    request_stop(number);
}

/// Handles a signal, unless whoever started this program has it ignored, as nohup does.
void handle(int number, void (*handler)(int)) {
    if (std::signal(number, handler) == SIG_IGN) std::signal(number, SIG_IGN);
}

}  // namespace

void install_signal_handlers() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) handle(number, request_stop_or_end);
    // Signals of a batch system whose time runs out, of a limit on processor time (each second anew), of a
    // timer.
    for (const int number : {SIGUSR1, SIGUSR2, SIGXCPU, SIGALRM, SIGVTALRM}) handle(number, request_stop);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested(const std::filesystem::path& stop_file) {
    if (signalled != 0) return true;
    if (::access(stop_file.c_str(), F_OK) != 0) return false;
    std::error_code ignored;
    std::filesystem::remove(stop_file, ignored);
    return true;
}

}  // namespace rockslope
