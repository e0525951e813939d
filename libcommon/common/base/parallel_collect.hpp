#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope {

/// Calls collect(begin, end, list) for consecutive ranges of [0, count), which depend on `count` only, and
/// joins the lists in the order of the ranges. The result does not depend on the number of threads.
template <class T, class Collect>
std::vector<T> parallel_collect(const ThreadPool& pool, std::size_t count, const Collect& collect) {
    constexpr std::size_t max_ranges = 64, min_range = 16;
    const std::size_t ranges = std::clamp<std::size_t>(count / min_range, 1, max_ranges);
    std::vector<std::vector<T>> lists(ranges);
    pool.parallel_for_dynamic(ranges, [&](std::size_t k, std::size_t) {
        collect(count * k / ranges, count * (k + 1) / ranges, lists[k]);
    });
    if (ranges == 1) return std::move(lists[0]);
    std::vector<std::size_t> first(ranges + 1, 0);
    for (std::size_t k = 0; k < ranges; ++k) first[k + 1] = first[k] + lists[k].size();
    std::vector<T> result(first.back());
    pool.parallel_for_dynamic(ranges, [&](std::size_t k, std::size_t) {
        std::copy(lists[k].begin(), lists[k].end(), result.begin() + static_cast<std::ptrdiff_t>(first[k]));
        lists[k] = {};
    });
    return result;
}

}  // namespace rockslope
