#include "stop_request.hpp"

#include <unistd.h>

#include <csignal>

namespace {

volatile std::sig_atomic_t signalled = 0;

void take_note(int number) {
    signalled = 1;
    std::signal(number, SIG_DFL);
}

}  // namespace

void listen_for_signals() {
    std::signal(SIGINT, take_note);
    std::signal(SIGTERM, take_note);
    std::signal(SIGHUP, take_note);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested(const std::filesystem::path& stop_file) {
    if (signalled != 0) return true;
    if (::access(stop_file.c_str(), F_OK) != 0) return false;
    std::error_code ignored;
    std::filesystem::remove(stop_file, ignored);
    return true;
}
