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

  private:
    struct Pool;
    int threads_;
    std::unique_ptr<Pool> pool_;
};

}  // namespace dda
