#include "common/base/thread_pool.hpp"

#include <atomic>

#include "common/base/worker_threads.hpp"

namespace rockslope {

namespace {
/// Shortest loop that is run in parallel. For a shorter one the hand-over costs more than it saves.
constexpr std::size_t min_parallel_length = 512;
}  // namespace

ThreadPool::ThreadPool(int threads) : threads_(std::max(threads, 1)) {
    if (threads_ > 1) workers_ = std::make_unique<WorkerThreads>(threads_ - 1);
}

ThreadPool::~ThreadPool() = default;

void ThreadPool::parallel_for(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const {
    if (!workers_ || count < min_parallel_length) {
        if (count > 0) body(0, count);
        return;
    }
    const std::size_t parts = threads_;
    workers_->run_on_all([&](std::size_t part) { body(count * part / parts, count * (part + 1) / parts); });
}

void ThreadPool::parallel_for_dynamic(std::size_t count,
                                      FunctionRef<void(std::size_t, std::size_t)> body) const {
    if (!workers_ || count < 2) {
        for (std::size_t k = 0; k < count; ++k) body(k, 0);
        return;
    }
    std::atomic<std::size_t> next{0};
    workers_->run_on_all([&](std::size_t part) {
        for (std::size_t k = next++; k < count; k = next++) body(k, part);
    });
}

}  // namespace rockslope
