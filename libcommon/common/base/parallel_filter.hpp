#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "common/base/thread_pool.hpp"

namespace rockslope {

/// Finds the indices below `count` for which is_selected(index) is true, ascending.
/// @param selected work space. @param indices receives them.
template <class Predicate>
void parallel_filter(const ThreadPool& pool, std::size_t count, const Predicate& is_selected,
                     std::vector<char>& selected, std::vector<std::size_t>& indices) {
    constexpr std::size_t chunk_limit = 64;
    constexpr std::size_t least_chunk = 512;
    const std::size_t length = std::max(least_chunk, (count + chunk_limit - 1) / chunk_limit);
    const std::size_t chunks = (count + length - 1) / length;
    const auto end_of_chunk = [&](std::size_t chunk) { return std::min((chunk + 1) * length, count); };
    selected.resize(count);
    std::array<std::size_t, chunk_limit + 1> first{};  // of a chunk, among the selected
    pool.parallel_for_dynamic(chunks, [&](std::size_t chunk, std::size_t) {
        const auto begin = selected.begin() + static_cast<std::ptrdiff_t>(chunk * length);
        for (std::size_t k = chunk * length; k < end_of_chunk(chunk); ++k)
            selected[k] = is_selected(k) ? 1 : 0;
        const auto end = selected.begin() + static_cast<std::ptrdiff_t>(end_of_chunk(chunk));
        first[chunk + 1] = static_cast<std::size_t>(std::count(begin, end, 1));
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    indices.resize(first.back());
    pool.parallel_for_dynamic(chunks, [&](std::size_t chunk, std::size_t) {
        std::size_t at = first[chunk];
        for (std::size_t k = chunk * length; k < end_of_chunk(chunk); ++k) {
            if (selected[k] != 0) indices[at++] = k;
        }
    });
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
