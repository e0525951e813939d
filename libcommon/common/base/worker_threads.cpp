#include "common/base/worker_threads.hpp"

#include <chrono>
#include <stdexcept>
#include <string>
#include <system_error>

namespace rockslope {

namespace {

/// How long a thread spins before it sleeps: about the cost of waking it.
constexpr std::chrono::microseconds spin_time{50};

void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

/// Returns when the number differs from `old_value`.
void wait_for_change(const std::atomic<int>& number, int old_value) {
    using Clock = std::chrono::steady_clock;
    constexpr int polls = 32;  // between readings of the clock
    const Clock::time_point end = Clock::now() + spin_time;
    do {
        for (int k = 0; k < polls; ++k) {
            if (number.load(std::memory_order_acquire) != old_value) return;
            pause();
        }
    } while (Clock::now() < end);
    number.wait(old_value, std::memory_order_acquire);
}

// Encoding of WorkerThreads::gate_.
constexpr int gate_open = 1;
constexpr int one_worker = 2;

/// Joins the call while its gate is open. @return false if it is closed.
bool try_enter(std::atomic<int>& gate) {
    int state = gate.load(std::memory_order_relaxed);
    while ((state & gate_open) != 0) {
        if (gate.compare_exchange_weak(state, state + one_worker, std::memory_order_acquire)) return true;
    }
    return false;
}

void leave(std::atomic<int>& gate) {
    if (gate.fetch_sub(one_worker, std::memory_order_acq_rel) == one_worker) gate.notify_one();
}

void close_and_wait(std::atomic<int>& gate) {
    int inside = gate.fetch_sub(gate_open, std::memory_order_acq_rel) - gate_open;
    for (; inside != 0; inside = gate.load(std::memory_order_acquire)) wait_for_change(gate, inside);
}

}  // namespace

WorkerThreads::WorkerThreads(std::size_t count) {
    failures_.resize(count + 1);
    threads_.reserve(count);
    try {
        for (std::size_t k = 0; k < count; ++k) threads_.emplace_back([this] { wait_for_work(); });
    } catch (const std::system_error& error) {
        const std::size_t started = threads_.size();
        stop();
        throw std::runtime_error(std::to_string(count + 1) + " threads cannot be started, only " +
                                 std::to_string(started + 1) + ": " + error.code().message());
    }
}

WorkerThreads::~WorkerThreads() {
    stop();
}

void WorkerThreads::stop() {
    stopping_ = true;
    generation_.fetch_add(1);
    generation_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void WorkerThreads::run_on_all(FunctionRef<void(std::size_t)> work) {
    work_ = &work;
    next_.store(1, std::memory_order_relaxed);
    gate_.store(gate_open, std::memory_order_release);
    generation_.fetch_add(1);
    generation_.notify_all();
    run_part(0);
    run_remaining_parts();
    close_and_wait(gate_);
    std::exception_ptr first;
    for (std::exception_ptr& failure : failures_) {
        if (failure && !first) first = failure;
        failure = nullptr;
    }
    if (first) std::rethrow_exception(first);
}

void WorkerThreads::wait_for_work() {
    for (int seen_generation = 0;;) {
        wait_for_change(generation_, seen_generation);
        seen_generation = generation_.load(std::memory_order_acquire);
        if (stopping_) return;
        if (!try_enter(gate_)) continue;
        run_remaining_parts();
        leave(gate_);
    }
}

void WorkerThreads::run_remaining_parts() {
    for (std::size_t part = next_++; part < failures_.size(); part = next_++) run_part(part);
}

void WorkerThreads::run_part(std::size_t part) {
    try {
        (*work_)(part);
    } catch (...) {
        failures_[part] = std::current_exception();
    }
}

}  // namespace rockslope
