#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "common/base/function_ref.hpp"

namespace rockslope {

/// Threads that stand by to help another one. For some tens of microseconds after they have helped they watch
/// for the next call, which reaches them within a microsecond; then they sleep. Whoever calls waits only for
/// those that have come, so a call costs little where none can.
class WorkerThreads {
  public:
    explicit WorkerThreads(std::size_t count);
    ~WorkerThreads();
    WorkerThreads(const WorkerThreads&) = delete;
    WorkerThreads& operator=(const WorkerThreads&) = delete;

    /// Calls work(part) once for part 0, in this thread, and for one more part for each one_worker, by the
    /// helpers that come and in this thread when it has done its own. One call at a time. Throws what work
    /// threw in the first part that failed.
    void run_on_all(FunctionRef<void(std::size_t)> work);

  private:
    void wait_for_work();
    /// Does the parts that no one has begun.
    void run_remaining_parts();
    void run_part(std::size_t part);

    static constexpr std::size_t cache_line = 64;
    alignas(cache_line) std::atomic<int> generation_{0};  ///< so far; what helpers wait for
    /// Twice the helpers that are at work, and 1 while more may join them.
    alignas(cache_line) std::atomic<int> gate_{0};
    alignas(cache_line) std::atomic<std::size_t> next_{0};  ///< part
    const FunctionRef<void(std::size_t)>* work_ = nullptr;
    std::atomic<bool> stopping_{false};
    std::vector<std::exception_ptr> failures_;  ///< per part
    std::vector<std::thread> threads_;
};

}  // namespace rockslope
