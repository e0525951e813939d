#pragma once

#include <cstddef>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope {

/// Collects what a loop finds: calls collect(begin, end) for as many parts of [0, count) as there are
/// threads. Lists that are joined in the order of the parts do not depend on their number. For work that is
/// even, parallel_collect() for other work.
/// @return what collect() returned for each part, in order.
template <class Collect>
auto parallel_parts(const ThreadPool& pool, std::size_t count, const Collect& collect) {
    constexpr std::size_t least_shared_count = 512;  // below it a hand-over costs more than it saves
    const std::size_t parts = count < least_shared_count ? 1 : static_cast<std::size_t>(pool.size());
    std::vector<decltype(collect(std::size_t{}, std::size_t{}))> found(parts);
    pool.parallel_for_dynamic(parts, [&](std::size_t part, std::size_t) {
        found[part] = collect(count * part / parts, count * (part + 1) / parts);
    });
    return found;
}

/// Appends the items that another part found to those of the parts before it.
template <class Item>
void append(std::vector<Item>& all, const std::vector<Item>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace rockslope
