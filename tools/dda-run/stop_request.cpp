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

void handle_signal(int number) {
    if (signalled == 0) {
        first_signal = std::time(nullptr);
        signalled = 1;
    } else if (std::time(nullptr) - first_signal > one_request) {
        std::signal(number, SIG_DFL);
        std::raise(number);
    }
}

}  // namespace

void install_signal_handlers() {
    std::signal(SIGINT, handle_signal);
    std::signal(SIGTERM, handle_signal);
    std::signal(SIGHUP, handle_signal);
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
