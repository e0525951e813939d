#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope {

/// Sorts values of a strict total order: ranges first, then merges of two neighbours. The result does not
/// depend on the number of threads, because equal values cannot be told apart.
template <class T, class Less = std::less<T>>
void parallel_sort(const ThreadPool& pool, std::vector<T>& values, const Less& less = {}) {
    constexpr std::size_t min_length = 1 << 14;
    std::size_t ranges = 1;
    while (ranges < static_cast<std::size_t>(pool.size()) && values.size() / ranges > min_length) ranges *= 2;
    const auto end_of = [&](std::size_t range) {
        return values.begin() + static_cast<std::ptrdiff_t>(values.size() * range / ranges);
    };
    pool.parallel_for_dynamic(ranges,
                              [&](std::size_t k, std::size_t) { std::sort(end_of(k), end_of(k + 1), less); });
    for (std::size_t merged = 1; merged < ranges; merged *= 2)
        pool.parallel_for_dynamic(ranges / (2 * merged), [&](std::size_t k, std::size_t) {
            const std::size_t first = 2 * merged * k;
            std::inplace_merge(end_of(first), end_of(first + merged), end_of(first + 2 * merged), less);
        });
}

}  // namespace rockslope
