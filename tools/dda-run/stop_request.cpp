#include "stop_request.hpp"

#include <unistd.h>

#include <csignal>

namespace rockslope {

namespace {

volatile std::sig_atomic_t signalled = 0;

void handle_signal(int number) {
    signalled = 1;
    std::signal(number, SIG_DFL);
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
