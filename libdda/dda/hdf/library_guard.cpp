#include "dda/hdf/library_guard.hpp"

#include <atomic>
#include <csetjmp>
#include <csignal>
#include <mutex>

namespace rockslope::dda {

namespace {

constexpr int faults[] = {SIGFPE, SIGSEGV, SIGBUS};

thread_local sigjmp_buf before_call;
thread_local volatile std::sig_atomic_t in_call = 0;
std::atomic<bool> failed{false};
struct sigaction actions_before[sizeof faults / sizeof faults[0]];

/// Leaves the call of the library. A fault elsewhere is handled as it would be without this: the instruction
/// is repeated.
void leave_call(int number) {
    if (in_call != 0) siglongjmp(before_call, 1);
    for (std::size_t k = 0; k < sizeof faults / sizeof faults[0]; ++k)
        if (faults[k] == number) ::sigaction(number, &actions_before[k], nullptr);
}

void install_handlers() {
    static std::once_flag once;
    std::call_once(once, [] {
        struct sigaction action {};
        action.sa_handler = leave_call;
        ::sigemptyset(&action.sa_mask);
        for (std::size_t k = 0; k < sizeof faults / sizeof faults[0]; ++k)
            ::sigaction(faults[k], &action, &actions_before[k]);
    });
}

}  // namespace

bool survives(void (*call)(void*), void* data) {
    install_handlers();
    if (sigsetjmp(before_call, 1) != 0) {
        in_call = 0;
        failed = true;
        return false;
    }
    in_call = 1;
    call(data);
    in_call = 0;
    return true;
}

bool library_has_failed() {
    return failed;
}

}  // namespace rockslope::dda
