#include <Eigen/SparseCholesky>
#include <algorithm>

#include "dda/linear/linear_solver.hpp"

namespace rockslope::dda {

namespace {

/// Eigen's simplicial Cholesky factorisation of the scalar matrix in elimination order. It calls no BLAS,
/// whose kernels, and with them the last digits, depend on the processor and on the environment.
class SimplicialSolver final : public LinearSolver {
  public:
    void analyze(const BlockPattern& pattern) override {
        order_ = fill_reducing_order(pattern);
        find_lower_blocks(pattern);
        lay_out();
        factor_.analyzePattern(matrix_);
    }

    bool factorize(const BlockMatrix& matrix) override {
        fill_values(matrix);
        factor_.factorize(matrix_);
        return factor_.info() == Eigen::Success;
    }

    void solve(std::vector<Vec6>& right_hand_side) override {
        Eigen::VectorXd permuted(matrix_.rows());
        for (std::size_t k = 0; k < order_.size(); ++k)
            permuted.segment<block_unknowns>(first_row(k)) = right_hand_side[order_[k]];
        const Eigen::VectorXd solved = factor_.solve(permuted);
        for (std::size_t k = 0; k < order_.size(); ++k)
            right_hand_side[order_[k]] = solved.segment<block_unknowns>(first_row(k));
    }

  private:
    /// A submatrix below the diagonal, in elimination order.
    struct LowerBlock {
        int row = 0;
        std::uint32_t source = 0;  ///< index into BlockMatrix::upper
        bool transposed = false;   ///< the transpose of the source is stored
    };

    static Eigen::Index first_row(std::size_t block) {
        return static_cast<Eigen::Index>(block) * block_unknowns;
    }

    /// Finds the submatrices below the diagonal in each block column.
    void find_lower_blocks(const BlockPattern& pattern) {
        std::vector<int> position(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) position[order_[k]] = static_cast<int>(k);
        lower_blocks_.assign(order_.size(), {});
        for (std::size_t i = 0; i < order_.size(); ++i) {
            for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
                const int a = position[i];
                const int b = position[pattern.columns[k]];
                lower_blocks_[std::min(a, b)].push_back({std::max(a, b), k, a < b});
            }
        }
        for (auto& column : lower_blocks_)
            std::sort(column.begin(), column.end(),
                      [](const LowerBlock& a, const LowerBlock& b) { return a.row < b.row; });
        entry_count_ = order_.size() * 21 + pattern.columns.size() * 36;
    }

    /// Gives the lower triangle its pattern, by columns.
    void lay_out() {
        const Eigen::Index size = first_row(order_.size());
        matrix_.resize(size, size);
        matrix_.resizeNonZeros(static_cast<Eigen::Index>(entry_count_));
        int* column_start = matrix_.outerIndexPtr();
        int* row = matrix_.innerIndexPtr();
        int filled = 0;
        int first = 0;  // row of the diagonal submatrix
        for (const auto& column : lower_blocks_) {
            for (int k = 0; k < block_unknowns; ++k) {
                *column_start++ = filled;
                for (int m = k; m < block_unknowns; ++m) row[filled++] = first + m;
                for (const LowerBlock& entry : column) {
                    for (int m = 0; m < block_unknowns; ++m) row[filled++] = entry.row * block_unknowns + m;
                }
            }
            first += block_unknowns;
        }
        *column_start = filled;
    }

    void fill_values(const BlockMatrix& matrix) {
        double* value = matrix_.valuePtr();
        for (std::size_t i = 0; i < order_.size(); ++i) {
            const Mat6& diagonal = matrix.diagonal[order_[i]];
            for (int k = 0; k < block_unknowns; ++k) {
                for (int m = k; m < block_unknowns; ++m) *value++ = diagonal(m, k);
                for (const LowerBlock& entry : lower_blocks_[i]) {
                    const Mat6& upper = matrix.upper[entry.source];
                    for (int m = 0; m < block_unknowns; ++m)
                        *value++ = entry.transposed ? upper(k, m) : upper(m, k);
                }
            }
        }
    }

    std::vector<int> order_;                             ///< elimination order
    std::vector<std::vector<LowerBlock>> lower_blocks_;  ///< by block column, rows ascending
    std::size_t entry_count_ = 0;                        ///< scalars in the lower triangle
    Eigen::SparseMatrix<double> matrix_;                 ///< lower triangle in elimination order
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_simplicial_solver() {
    return std::make_unique<SimplicialSolver>();
}

}  // namespace rockslope::dda
