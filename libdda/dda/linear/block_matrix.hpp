#pragma once

#include <span>
#include <utility>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"

namespace rockslope::dda {

/// Unknowns of a block: rows and columns of a submatrix.
inline constexpr int block_unknowns = 6;

/// Pattern of the 6x6 submatrices of a symmetric block matrix that may be non-zero, Eq. (3): the diagonal,
/// and in row i the columns columns[start[i]] ... columns[start[i + 1] - 1], all greater than i and
/// ascending.
struct BlockPattern {
    std::size_t size = 0;
    PerRow<std::uint32_t> start = {0};
    std::vector<RowIndex> columns;

    /// @param pairs (i, j) with i != j in any order, repetitions allowed.
    static BlockPattern from_pairs(std::size_t size, std::vector<std::pair<RowIndex, RowIndex>> pairs);
    /// The position of submatrix (row, column), row < column, in `columns`. It must exist.
    std::size_t position(RowIndex row, RowIndex column) const;
    friend bool operator==(const BlockPattern&, const BlockPattern&) = default;
};

/// A symmetric block matrix: the diagonal and the upper triangle.
struct BlockMatrix {
    PerRow<Mat6> diagonal;    ///< one per row
    std::vector<Mat6> upper;  ///< one per column entry of the pattern, K_ij with i < j

    /// Takes the size of the pattern; all entries become zero.
    void reset(const BlockPattern& pattern);
    /// y = A x. Gives the same bytes with any number of threads.
    void multiply(const BlockPattern& pattern, std::span<const Vec6> x, std::span<Vec6> y,
                  const ThreadPool& pool) const;
    void multiply(const BlockPattern& pattern, std::span<const Vec6> x, std::span<Vec6> y) const {
        multiply(pattern, x, y, ThreadPool(1));
    }
    /// Adds stiffness * vector * vector^T on the diagonal.
    void add_rank_one(RowIndex row, const Vec6& vector, double stiffness) {
        diagonal[row].noalias() += (stiffness * vector) * vector.transpose();
    }
    /// Adds first * second^T at (i, j) and its transpose at (j, i); i != j.
    void add_outer(const BlockPattern& pattern, RowIndex i, RowIndex j, const Vec6& first,
                   const Vec6& second);
};

}  // namespace rockslope::dda
