#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope {

/// Finds the indices below `count` for which is_selected(index) is true, ascending.
/// @param selected work space. @param indices receives them.
template <class Predicate>
void parallel_filter(const ThreadPool& pool, std::size_t count, const Predicate& is_selected,
                     std::vector<char>& selected, std::vector<std::size_t>& indices) {
    selected.resize(count);
    pool.parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) selected[k] = is_selected(k) ? 1 : 0;
    });
    indices.clear();
    indices.reserve(std::count(selected.begin(), selected.end(), 1));
    for (std::size_t k = 0; k < count; ++k) {
        if (selected[k] != 0) indices.push_back(k);
    }
}

/// The indices below `count` for which is_selected(index) is true, ascending.
template <class Predicate>
std::vector<std::size_t> parallel_filter(const ThreadPool& pool, std::size_t count,
                                         const Predicate& is_selected) {
    std::vector<char> selected;
    std::vector<std::size_t> indices;
    parallel_filter(pool, count, is_selected, selected, indices);
    return indices;
}

}  // namespace rockslope
