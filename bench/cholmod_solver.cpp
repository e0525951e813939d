#include "cholmod_solver.hpp"

#include <cholmod.h>
#include <dlfcn.h>
#include <omp.h>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace rockslope::bench {

using namespace dda;

namespace {

/// Makes CHOLMOD and the BLAS single-threaded. Their threads wait for each other longer than a supernode of a
/// few blocks takes (four threads on two cores take five times as long), and the sums would depend on the
/// number of threads.
void stay_single_threaded() {
    omp_set_max_active_levels(0);
    // Only OpenBLAS has this function. Other BLAS libraries keep their setting.
    using SetThreads = void (*)(int);
    if (auto* set_threads = reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
        set_threads(1);
}

class CholmodSolver final : public LinearSolver {
  public:
    CholmodSolver() {
        stay_single_threaded();
        cholmod_start(&common_);
        common_.supernodal = CHOLMOD_SUPERNODAL;
        common_.final_ll = 1;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_NATURAL;
        common_.postorder = 0;
        common_.print = 0;
        common_.quick_return_if_not_posdef = 1;
    }
    ~CholmodSolver() override {
        release();
        cholmod_free_dense(&solution_, &common_);
        cholmod_free_dense(&work_y_, &common_);
        cholmod_free_dense(&work_e_, &common_);
        cholmod_finish(&common_);
    }
    CholmodSolver(const CholmodSolver&) = delete;
    CholmodSolver& operator=(const CholmodSolver&) = delete;

    /// The scalar matrix is stored in elimination order. Letting CHOLMOD permute it at each factorisation
    /// costs a tenth more.
    void analyze(const BlockPattern& pattern) override {
        release();
        order_ = fill_reducing_order(pattern);
        find_lower_blocks(pattern);
        allocate_scalar_matrix();
        factor_ = cholmod_analyze(matrix_, &common_);
        if (factor_ == nullptr) throw std::bad_alloc();
    }

    bool factorize(const BlockMatrix& matrix) override {
        fill_values(matrix);
        if (cholmod_factorize(matrix_, factor_, &common_) == 0) throw std::bad_alloc();
        return common_.status != CHOLMOD_NOT_POSDEF;
    }

    void solve(std::vector<Vec6>& right_hand_side) override {
        permuted_.resize(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) permuted_[k] = right_hand_side[order_[k]];
        cholmod_dense b{};
        b.nrow = order_.size() * block_unknowns;
        b.ncol = 1;
        b.nzmax = b.nrow;
        b.d = b.nrow;
        b.x = permuted_.data();
        b.xtype = CHOLMOD_REAL;
        b.dtype = CHOLMOD_DOUBLE;
        if (cholmod_solve2(CHOLMOD_A, factor_, &b, nullptr, &solution_, nullptr, &work_y_, &work_e_,
                           &common_) == 0) {
            throw std::bad_alloc();
        }
        const auto* solved = static_cast<const double*>(solution_->x);
        for (const int block : order_) {
            right_hand_side[block] = Eigen::Map<const Vec6>(solved);
            solved += block_unknowns;
        }
    }

  private:
    void release() {
        cholmod_free_factor(&factor_, &common_);
        cholmod_free_sparse(&matrix_, &common_);
    }

    /// A submatrix below the diagonal, in elimination order.
    struct LowerBlock {
        int row = 0;
        std::uint32_t source = 0;  ///< index into BlockMatrix::upper
        bool transposed = false;   ///< the transpose of the source is stored
    };

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

    /// Allocates the lower triangle in compressed columns and sets its pattern.
    void allocate_scalar_matrix() {
        const std::size_t size = order_.size() * block_unknowns;
        matrix_ = cholmod_allocate_sparse(size, size, entry_count_, 1, 1, -1, CHOLMOD_REAL, &common_);
        if (matrix_ == nullptr) throw std::bad_alloc();
        auto* column_start = static_cast<int*>(matrix_->p);
        auto* row = static_cast<int*>(matrix_->i);
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
        auto* value = static_cast<double*>(matrix_->x);
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

    cholmod_common common_{};
    std::vector<int> order_;                             ///< elimination order
    std::vector<std::vector<LowerBlock>> lower_blocks_;  ///< by block column, rows ascending
    std::size_t entry_count_ = 0;                        ///< scalars in the lower triangle
    std::vector<Vec6> permuted_;                         ///< right-hand side in elimination order
    cholmod_sparse* matrix_ = nullptr;
    cholmod_factor* factor_ = nullptr;
    cholmod_dense* solution_ = nullptr;
    cholmod_dense* work_y_ = nullptr;
    cholmod_dense* work_e_ = nullptr;
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod_solver() {
    return std::make_unique<CholmodSolver>();
}

}  // namespace rockslope::bench
