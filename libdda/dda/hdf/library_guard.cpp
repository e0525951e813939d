#include "dda/hdf/library_guard.hpp"

#include <sys/time.h>

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

/// Leaves a call that does not end. The timer goes on, should another thread have got its signal.
void leave_endless_call(int) {
    if (in_call != 0) siglongjmp(before_call, 1);
}

/// Sets the timer of processor time, s; 0 stops it.
void set_timer(double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec =
        static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
    timer.it_interval = timer.it_value;
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

void install_handlers() {
    static std::once_flag once;
    std::call_once(once, [] {
        struct sigaction action {};
        action.sa_handler = leave_call;
        ::sigemptyset(&action.sa_mask);
        for (std::size_t k = 0; k < sizeof faults / sizeof faults[0]; ++k)
            ::sigaction(faults[k], &action, &actions_before[k]);
        action.sa_handler = leave_endless_call;
        action.sa_flags = SA_RESTART;
        ::sigaction(SIGPROF, &action, nullptr);
    });
}

}  // namespace

bool survives(void (*call)(void*), void* data, double seconds) {
    install_handlers();
    if (sigsetjmp(before_call, 1) != 0) {
        in_call = 0;
        set_timer(0);
        failed = true;
        return false;
    }
    set_timer(seconds);
    in_call = 1;
    call(data);
    in_call = 0;
    set_timer(0);
    return true;
}

bool library_has_failed() {
    return failed;
}

}  // namespace rockslope::dda
