#pragma once

#include <span>
#include <vector>

#include "dda/base/types.hpp"

namespace rockslope::dda {

/// LU factors of a small unsymmetric matrix of 6x6 submatrices, for a patch of some tens of blocks. The
/// submatrices lie in an envelope: those of a column from its first to its last row, the same above and below
/// the diagonal. There is no pivoting between submatrices, within them there is. Memory is kept from matrix
/// to matrix.
class EnvelopeLu {
  public:
    /// Sets a zero matrix. @param last per column, the last row with a submatrix: at least the column, and
    /// never less than that of the column before.
    void reset(std::span<const int> last);
    /// Adds to a submatrix, which must be inside the envelope.
    void add(int row, int column, const Mat6& part);
    /// Factorises. @return the sign of the determinant: 1, -1, or 0 where it is zero or not a number.
    int factorize();
    /// Solves A x = b. @param x b on entry, one entry a row.
    void solve(std::span<Vec6> x) const;

    /// The number of columns of submatrices.
    int size() const { return static_cast<int>(columns_.size()); }

  private:
    /// The submatrices of a column, one above the other, stored by columns of scalars.
    struct Column {
        int first = 0;
        int last = 0;
        std::size_t begin = 0;  ///< of its scalars

        long stride() const { return 6L * (last - first + 1); }
        std::size_t at(int row) const { return begin + 6 * static_cast<std::size_t>(row - first); }
    };
    /// A 6x6 submatrix, which has the stride of its column.
    auto block(int row, const Column& column) {
        return Eigen::Map<Mat6, 0, Eigen::OuterStride<>>(&scalars_[column.at(row)],
                                                         Eigen::OuterStride<>(column.stride()));
    }
    /// Multiplies the submatrices of a column below its pivot by the inverse of the pivot.
    void scale(const Column& pivot, int row, const Mat6& inverse);

    std::vector<Column> columns_;
    std::vector<double> scalars_;
    std::vector<Mat6> inverses_;  ///< of the pivots
    std::vector<double> scaled_;  ///< work space
};

}  // namespace rockslope::dda
