#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "common/base/function_ref.hpp"

namespace rockslope {

/// Worker threads of a pool. After a call they spin for some tens of microseconds, so that the next call
/// reaches them within a microsecond; then they sleep. The caller waits only for workers that have joined
/// the call, so a call costs little when no worker is free.
class WorkerThreads {
  public:
    /// @throws std::runtime_error when the system does not start so many; none is left then.
    explicit WorkerThreads(std::size_t count);
    ~WorkerThreads();
    WorkerThreads(const WorkerThreads&) = delete;
    WorkerThreads& operator=(const WorkerThreads&) = delete;

    /// Calls work(part) once for each part: part 0 in the calling thread, and one more part per worker
    /// thread in the workers that join or, when part 0 is done, in the calling thread. One call at a time.
    /// Rethrows the exception of the first part that failed.
    void run_on_all(FunctionRef<void(std::size_t)> work);

  private:
    void stop();
    void wait_for_work();
    /// Runs the parts that no thread has started.
    void run_remaining_parts();
    void run_part(std::size_t part);

    static constexpr std::size_t cache_line = 64;
    alignas(cache_line) std::atomic<int> generation_{0};  ///< number of calls; workers wait for its change
    /// Twice the number of workers inside the call, plus 1 while more may join.
    alignas(cache_line) std::atomic<int> gate_{0};
    alignas(cache_line) std::atomic<std::size_t> next_{0};  ///< next part to start
    const FunctionRef<void(std::size_t)>* work_ = nullptr;
    std::atomic<bool> stopping_{false};
    std::vector<std::exception_ptr> failures_;  ///< per part
    std::vector<std::thread> threads_;
};

}  // namespace rockslope
