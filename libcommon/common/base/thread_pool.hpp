#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include "common/base/function_ref.hpp"

namespace rockslope {

class WorkerThreads;

/// A fixed pool of threads for loops with independent iterations. Each index is computed by exactly one
/// thread and writes only its own results, and sums are taken over chunks that do not depend on the number
/// of threads. A loop therefore gives the same bytes with any number of threads. A pool runs one loop at a
/// time.
class ThreadPool {
  public:
    /// @param threads at least 1; 1 runs every loop in the calling thread.
    explicit ThreadPool(int threads = 1);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Number of threads.
    int size() const { return threads_; }
    /// Calls body(begin, end) for ranges that cover [0, count), one per thread. Short loops stay in the
    /// calling thread.
    void parallel_for(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const;
    /// Calls body(index, thread) for each index in [0, count); a free thread takes the next index. For few
    /// long tasks, longest first. Threads are numbered from zero, so that each can have its own work space.
    void parallel_for_dynamic(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const;
    /// Computes chunk_value(begin, end) for chunks of [0, count) and combines them in order, starting from
    /// `initial`: result = combine(result, chunk_value). The chunks depend on `count` only.
    template <class Value, class ChunkValue, class Combine>
    Value parallel_reduce(std::size_t count, Value initial, const ChunkValue& chunk_value,
                          const Combine& combine) const;

  private:
    static constexpr std::size_t max_chunks = 64;
    static constexpr std::size_t min_chunk_length = 64;

    int threads_;
    std::unique_ptr<WorkerThreads> workers_;
};

template <class Value, class ChunkValue, class Combine>
Value ThreadPool::parallel_reduce(std::size_t count, Value initial, const ChunkValue& chunk_value,
                                  const Combine& combine) const {
    const std::size_t length = std::max(min_chunk_length, (count + max_chunks - 1) / max_chunks);
    std::array<Value, max_chunks> chunk_values;
    const std::size_t chunks = (count + length - 1) / length;
    const auto chunk_end = [&](std::size_t chunk) { return std::min((chunk + 1) * length, count); };
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = (begin + length - 1) / length; k * length < end; ++k)
            chunk_values[k] = chunk_value(k * length, chunk_end(k));
    });
    for (std::size_t k = 0; k < chunks; ++k) initial = combine(initial, chunk_values[k]);
    return initial;
}

}  // namespace rockslope
