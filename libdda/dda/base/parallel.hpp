#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include "dda/base/function_ref.hpp"

namespace dda {

class Helpers;

/// A fixed crew of threads for loops whose iterations are independent. Each index is computed by exactly one
/// thread and writes only its own results, so a loop gives the same bytes with any number of threads; sums
/// are taken over portions that do not depend on it. A crew does one loop at a time.
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
    void for_ranges(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const;
    /// Calls body(index, thread) for each index in [0, count), the next one by whichever thread is free: for
    /// few long tasks, the longest first. Threads count from zero, for work space of their own.
    void for_tasks(std::size_t count, FunctionRef<void(std::size_t, std::size_t)> body) const;
    /// of_portion(begin, end) for portions of [0, count), taken together in their order: `start`, then
    /// join(so far, the next one's). Portions depend on `count` alone.
    template <class Value, class OfPortion, class Join>
    Value taken_together(std::size_t count, Value start, const OfPortion& of_portion, const Join& join) const;

  private:
    static constexpr std::size_t most_portions = 64;
    static constexpr std::size_t least_portion = 64;

    int threads_;
    std::unique_ptr<Helpers> helpers_;
};

template <class Value, class OfPortion, class Join>
Value Crew::taken_together(std::size_t count, Value start, const OfPortion& of_portion,
                           const Join& join) const {
    const std::size_t length = std::max(least_portion, (count + most_portions - 1) / most_portions);
    std::array<Value, most_portions> of_portions;
    const std::size_t portions = (count + length - 1) / length;
    const auto end_of = [&](std::size_t portion) { return std::min((portion + 1) * length, count); };
    for_ranges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = (begin + length - 1) / length; p * length < end; ++p)
            of_portions[p] = of_portion(p * length, end_of(p));
    });
    for (std::size_t p = 0; p < portions; ++p) start = join(start, of_portions[p]);
    return start;
}

}  // namespace dda
