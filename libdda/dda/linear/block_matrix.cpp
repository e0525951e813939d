#include "dda/linear/block_matrix.hpp"

#include <algorithm>
#include <cassert>

namespace rockslope::dda {

namespace {
constexpr std::size_t max_chunks = 8;
constexpr std::size_t min_chunk_length = 128;
}  // namespace

BlockPattern BlockPattern::from_pairs(std::size_t size, std::vector<std::pair<RowIndex, RowIndex>> pairs) {
    for (auto& [i, j] : pairs) {
        if (i > j) std::swap(i, j);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    BlockPattern pattern;
    pattern.size = size;
    pattern.start.assign(size + 1, 0);
    pattern.columns.reserve(pairs.size());
    for (const auto& [i, j] : pairs) {
        ++pattern.start[i + 1];
        pattern.columns.push_back(j);
    }
    for (std::size_t i = 0; i < size; ++i) pattern.start[i + 1] += pattern.start[i];
    return pattern;
}

std::size_t BlockPattern::position(RowIndex row, RowIndex column) const {
    const auto first = columns.begin() + start[row];
    const auto last = columns.begin() + start[row + 1];
    const auto found = std::lower_bound(first, last, column);
    assert(found != last && *found == column);
    return found - columns.begin();
}

void BlockMatrix::reset(const BlockPattern& pattern) {
    diagonal.assign(pattern.size, Mat6::Zero());
    upper.assign(pattern.columns.size(), Mat6::Zero());
}

// Threads take chunks of rows. The chunks depend only on the number of rows, so the sums do not depend on
// the number of threads. Each upper entry is read once and contributes to both of its rows. Contributions to
// a row of a later chunk are added serially at the end; there are few where touching blocks have near
// numbers.
void BlockMatrix::multiply(const BlockPattern& pattern, std::span<const Vec6> x, std::span<Vec6> y,
                           const ThreadPool& pool) const {
    const std::size_t length = std::max(min_chunk_length, (x.size() + max_chunks - 1) / max_chunks);
    const std::size_t chunks = (x.size() + length - 1) / length;
    const auto end_of = [&](std::size_t chunk) { return std::min((chunk + 1) * length, x.size()); };
    const auto column = [&](std::size_t k) { return std::size_t{pattern.columns[k]}; };
    pool.parallel_for_dynamic(chunks, [&](std::size_t chunk, std::size_t) {
        const std::size_t end = end_of(chunk);
        for (std::size_t i = chunk * length; i < end; ++i) y[i].noalias() = diagonal[i] * x[i];
        for (std::size_t i = chunk * length; i < end; ++i) {
            for (std::size_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
                const std::size_t j = column(k);
                y[i].noalias() += upper[k] * x[j];
                if (j < end) y[j].noalias() += upper[k].transpose() * x[i];
            }
        }
    });
    for (std::size_t chunk = 0; chunk + 1 < chunks; ++chunk) {
        const std::size_t end = end_of(chunk);
        for (std::size_t i = chunk * length; i < end; ++i) {
            for (std::size_t k = pattern.start[i + 1]; k-- > pattern.start[i] && column(k) >= end;)
                y[column(k)].noalias() += upper[k].transpose() * x[i];
        }
    }
}

void BlockMatrix::add_outer(const BlockPattern& pattern, RowIndex i, RowIndex j, const Vec6& first,
                            const Vec6& second) {
    if (i < j) {
        upper[pattern.position(i, j)].noalias() += first * second.transpose();
    } else {
        upper[pattern.position(j, i)].noalias() += second * first.transpose();
    }
}

}  // namespace rockslope::dda
