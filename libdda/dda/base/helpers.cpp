#include "dda/base/helpers.hpp"

#include <chrono>

namespace dda {

namespace {

/// How long a thread watches before it sleeps: about what waking it would cost.
constexpr std::chrono::microseconds watching{50};

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

/// Returns when a number is no longer what it was.
void wait_while(const std::atomic<int>& number, int what_it_was) {
    using Clock = std::chrono::steady_clock;
    constexpr int polls = 32;  // between looks at the clock
    const Clock::time_point end = Clock::now() + watching;
    do {
        for (int k = 0; k < polls; ++k) {
            if (number.load(std::memory_order_acquire) != what_it_was) return;
            pause();
        }
    } while (Clock::now() < end);
    number.wait(what_it_was, std::memory_order_acquire);
}

constexpr int open = 1;    // see Helpers::door_
constexpr int helper = 2;  // likewise

/// Whether there still was something to help with.
bool enter(std::atomic<int>& door) {
    int now = door.load(std::memory_order_relaxed);
    while ((now & open) != 0) {
        if (door.compare_exchange_weak(now, now + helper, std::memory_order_acquire)) return true;
    }
    return false;
}

void leave(std::atomic<int>& door) {
    if (door.fetch_sub(helper, std::memory_order_acq_rel) == helper) door.notify_one();
}

void close_and_wait(std::atomic<int>& door) {
    int inside = door.fetch_sub(open, std::memory_order_acq_rel) - open;
    for (; inside != 0; inside = door.load(std::memory_order_acquire)) wait_while(door, inside);
}

}  // namespace

Helpers::Helpers(std::size_t count) {
    failures_.resize(count + 1);
    threads_.reserve(count);
    for (std::size_t k = 0; k < count; ++k) threads_.emplace_back([this] { stand_by(); });
}

Helpers::~Helpers() {
    go_home_ = true;
    calls_.fetch_add(1);
    calls_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void Helpers::work_together(FunctionRef<void(std::size_t)> work) {
    work_ = &work;
    next_.store(1, std::memory_order_relaxed);
    door_.store(open, std::memory_order_release);
    calls_.fetch_add(1);
    calls_.notify_all();
    do_part(0);
    do_parts();
    close_and_wait(door_);
    std::exception_ptr first;
    for (std::exception_ptr& failure : failures_) {
        if (failure && !first) first = failure;
        failure = nullptr;
    }
    if (first) std::rethrow_exception(first);
}

void Helpers::stand_by() {
    for (int answered = 0;;) {
        wait_while(calls_, answered);
        answered = calls_.load(std::memory_order_acquire);
        if (go_home_) return;
        if (!enter(door_)) continue;
        do_parts();
        leave(door_);
    }
}

void Helpers::do_parts() {
    for (std::size_t part = next_++; part < failures_.size(); part = next_++) do_part(part);
}

void Helpers::do_part(std::size_t part) {
    try {
        (*work_)(part);
    } catch (...) {
        failures_[part] = std::current_exception();
    }
}

}  // namespace dda
