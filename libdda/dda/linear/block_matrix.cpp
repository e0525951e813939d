#include "dda/linear/block_matrix.hpp"

#include <algorithm>
#include <cassert>

namespace rockslope::dda {

namespace {
constexpr std::size_t max_chunks = 8;
constexpr std::size_t min_chunk_length = 128;
}  // namespace

BlockPattern BlockPattern::from_pairs(int size, std::vector<std::pair<int, int>> pairs) {
    for (auto& [i, j] : pairs) {
        if (i > j) std::swap(i, j);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    BlockPattern pattern;
    pattern.size = size;
    pattern.start.assign(static_cast<std::size_t>(size) + 1, 0);
    pattern.columns.reserve(pairs.size());
    for (const auto& [i, j] : pairs) {
        ++pattern.start[static_cast<std::size_t>(i) + 1];
        pattern.columns.push_back(j);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) pattern.start[i + 1] += pattern.start[i];
    return pattern;
}

int BlockPattern::position(int row, int column) const {
    const auto first = columns.begin() + start[static_cast<std::size_t>(row)];
    const auto last = columns.begin() + start[static_cast<std::size_t>(row) + 1];
    const auto found = std::lower_bound(first, last, column);
    assert(found != last && *found == column);
    return static_cast<int>(found - columns.begin());
}

void BlockMatrix::reset(const BlockPattern& pattern) {
    diagonal.assign(static_cast<std::size_t>(pattern.size), Mat6::Zero());
    upper.assign(pattern.columns.size(), Mat6::Zero());
}

// Portions of rows, which depend on their number alone, by whoever is free: each entry is read once and
// serves both of its rows. What an entry gives to a row of a later chunk waits until all have ended; where
// blocks that touch have numbers near each other these are few.
void BlockMatrix::multiply(const BlockPattern& pattern, std::span<const Vec6> x, std::span<Vec6> y,
                           const ThreadPool& pool) const {
    const std::size_t length = std::max(min_chunk_length, (x.size() + max_chunks - 1) / max_chunks);
    const std::size_t chunks = (x.size() + length - 1) / length;
    const auto end_of = [&](std::size_t chunk) { return std::min((chunk + 1) * length, x.size()); };
    const auto begin_of_row = [&](std::size_t i) { return static_cast<std::size_t>(pattern.start[i]); };
    const auto column = [&](std::size_t k) { return static_cast<std::size_t>(pattern.columns[k]); };
    pool.parallel_for_dynamic(chunks, [&](std::size_t chunk, std::size_t) {
        const std::size_t end = end_of(chunk);
        for (std::size_t i = chunk * length; i < end; ++i) y[i].noalias() = diagonal[i] * x[i];
        for (std::size_t i = chunk * length; i < end; ++i) {
            for (std::size_t k = begin_of_row(i); k < begin_of_row(i + 1); ++k) {
                const std::size_t j = column(k);
                y[i].noalias() += upper[k] * x[j];
                if (j < end) y[j].noalias() += upper[k].transpose() * x[i];
            }
        }
    });
    for (std::size_t chunk = 0; chunk + 1 < chunks; ++chunk) {
        const std::size_t end = end_of(chunk);
        for (std::size_t i = chunk * length; i < end; ++i) {
            for (std::size_t k = begin_of_row(i + 1); k-- > begin_of_row(i) && column(k) >= end;)
                y[column(k)].noalias() += upper[k].transpose() * x[i];
        }
    }
}

void BlockMatrix::add_outer(const BlockPattern& pattern, int i, int j, const Vec6& first,
                            const Vec6& second) {
    if (i < j) {
        upper[static_cast<std::size_t>(pattern.position(i, j))].noalias() += first * second.transpose();
    } else {
        upper[static_cast<std::size_t>(pattern.position(j, i))].noalias() += second * first.transpose();
    }
}

}  // namespace rockslope::dda
