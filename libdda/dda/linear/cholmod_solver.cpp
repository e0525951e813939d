#include <cholmod.h>
#include <dlfcn.h>
#include <omp.h>

#include <cstring>
#include <new>
#include <stdexcept>

#include "dda/linear/linear_solver.hpp"

namespace dda {

namespace {

constexpr int unknowns = 6;

/// Keeps CHOLMOD's and the BLAS' own threads out: they wait for each other longer than a supernode of a few
/// blocks takes (four threads on two cores cost five times the time), and sums would depend on their number.
void stay_single_threaded() {
    omp_set_max_active_levels(0);
    // Only OpenBLAS has this function; another BLAS is left alone.
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
        common_.method[0].ordering = CHOLMOD_GIVEN;
        common_.postorder = 1;
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

    void analyze(const BlockPattern& pattern) override {
        release();
        pattern_ = pattern;
        allocate_scalar_matrix();
        std::vector<int> permutation;
        permutation.reserve(static_cast<std::size_t>(pattern.size) * unknowns);
        for (const int block : fill_reducing_order(pattern)) {
            for (int k = 0; k < unknowns; ++k) permutation.push_back(block * unknowns + k);
        }
        factor_ = cholmod_analyze_p(matrix_, permutation.data(), nullptr, 0, &common_);
        if (factor_ == nullptr) throw std::bad_alloc();
    }

    bool factorize(const BlockMatrix& matrix) override {
        fill_values(matrix);
        if (cholmod_factorize(matrix_, factor_, &common_) == 0) throw std::bad_alloc();
        return common_.status != CHOLMOD_NOT_POSDEF;
    }

    void solve(std::vector<Vec6>& right_hand_side) override {
        cholmod_dense b{};
        b.nrow = static_cast<std::size_t>(pattern_.size) * unknowns;
        b.ncol = 1;
        b.nzmax = b.nrow;
        b.d = b.nrow;
        b.x = right_hand_side.data();
        b.xtype = CHOLMOD_REAL;
        b.dtype = CHOLMOD_DOUBLE;
        if (cholmod_solve2(CHOLMOD_A, factor_, &b, nullptr, &solution_, nullptr, &work_y_, &work_e_,
                           &common_) == 0) {
            throw std::bad_alloc();
        }
        std::memcpy(static_cast<void*>(right_hand_side.data()), solution_->x, b.nrow * sizeof(double));
    }

  private:
    void release() {
        cholmod_free_factor(&factor_, &common_);
        cholmod_free_sparse(&matrix_, &common_);
    }

    /// The lower triangle by columns: column block i holds its diagonal and, below it, the transposes of the
    /// upper row i.
    void allocate_scalar_matrix() {
        const auto size = static_cast<std::size_t>(pattern_.size) * unknowns;
        const std::size_t entries =
            static_cast<std::size_t>(pattern_.size) * 21 + pattern_.columns.size() * 36;
        matrix_ = cholmod_allocate_sparse(size, size, entries, 1, 1, -1, CHOLMOD_REAL, &common_);
        if (matrix_ == nullptr) throw std::bad_alloc();
        auto* column_start = static_cast<int*>(matrix_->p);
        auto* row = static_cast<int*>(matrix_->i);
        int filled = 0;
        for (int i = 0; i < pattern_.size; ++i) {
            for (int k = 0; k < unknowns; ++k) {
                column_start[i * unknowns + k] = filled;
                for (int m = k; m < unknowns; ++m) row[filled++] = i * unknowns + m;
                for (int entry = pattern_.start[static_cast<std::size_t>(i)];
                     entry < pattern_.start[static_cast<std::size_t>(i) + 1]; ++entry) {
                    const int j = pattern_.columns[static_cast<std::size_t>(entry)];
                    for (int m = 0; m < unknowns; ++m) row[filled++] = j * unknowns + m;
                }
            }
        }
        column_start[size] = filled;
    }

    void fill_values(const BlockMatrix& matrix) {
        auto* value = static_cast<double*>(matrix_->x);
        for (int i = 0; i < pattern_.size; ++i) {
            const Mat6& diagonal = matrix.diagonal[static_cast<std::size_t>(i)];
            for (int k = 0; k < unknowns; ++k) {
                for (int m = k; m < unknowns; ++m) *value++ = diagonal(m, k);
                for (int entry = pattern_.start[static_cast<std::size_t>(i)];
                     entry < pattern_.start[static_cast<std::size_t>(i) + 1]; ++entry) {
                    const Mat6& upper = matrix.upper[static_cast<std::size_t>(entry)];
                    for (int m = 0; m < unknowns; ++m) *value++ = upper(k, m);
                }
            }
        }
    }

    cholmod_common common_{};
    BlockPattern pattern_;
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

}  // namespace dda
