#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace dda {

/// A fixed crew of threads for loops whose iterations are independent. Each index is computed by exactly one
/// thread and writes only its own results, so a loop gives the same bytes with any number of threads; sums
/// are the caller's, in order.
class Crew {
  public:
    /// @param threads at least 1; 1 runs every loop in the calling thread.
    explicit Crew(int threads = 1);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    int size() const { return threads_; }
    /// Calls body(begin, end) for ranges that together cover [0, count); short loops stay in the calling
    /// thread.
    void for_ranges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) const;
    /// Calls body(index, thread) for each index in [0, count), the next one by whichever thread is free: for
    /// few long tasks, the longest first. Threads count from zero, for work space of their own.
    void for_tasks(std::size_t count, const std::function<void(std::size_t, std::size_t)>& body) const;

  private:
    struct Pool;
    /// Calls work(part) for each thread's part, its own one in this thread.
    void in_parts(const std::function<void(std::size_t)>& work) const;
    int threads_;
    std::unique_ptr<Pool> pool_;
};

}  // namespace dda
