#include "dda/linear/block_matrix.hpp"

#include <algorithm>
#include <cassert>

namespace dda {

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

void BlockMatrix::multiply(const BlockPattern& pattern, std::span<const Vec6> x, std::span<Vec6> y) const {
    for (std::size_t i = 0; i < x.size(); ++i) y[i].noalias() = diagonal[i] * x[i];
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const auto place = static_cast<std::size_t>(k);
            const auto j = static_cast<std::size_t>(pattern.columns[place]);
            y[i].noalias() += upper[place] * x[j];
            y[j].noalias() += upper[place].transpose() * x[i];
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

}  // namespace dda
