#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/linear/aligned_buffer.hpp"
#include "dda/linear/front_kernels.hpp"
#include "dda/linear/symbolic_factor.hpp"

namespace rockslope::dda {

/// Substitutions with a factor of fewer scalars than this run on one thread: some 70 us of work.
inline constexpr std::size_t min_parallel_factor_size = std::size_t{1} << 19;

/// Multifrontal Cholesky factorisation A = L L^T of a symmetric block matrix: dense work on fronts, with the
/// subtrees of the assembly tree distributed over threads. The factor is the same bytes with any number of
/// threads. [Duff & Reid 1983]
/// @tparam Scalar precision of the factor, float or double. The matrix is always in double precision.
template <class Scalar>
class MultifrontalFactor {
  public:
    /// Symbolic factorisation; allocates the memory of the factor.
    /// @param max_kept see max_kept_updates.
    void analyze(const BlockPattern& pattern, const SupernodeTree& tree,
                 std::size_t max_kept = max_kept_updates);
    /// @param changed per row, non-zero where the row or the column of the matrix may differ from the last
    /// one; empty: everywhere. With kept updates only the fronts of such rows and their ancestors are
    /// factorised again, to the same bytes as in a full factorisation.
    /// @return false when the matrix is not positive definite in this precision. There is no factor then.
    bool factorize(const BlockMatrix& matrix, const ThreadPool& pool, std::span<const char> changed = {});
    /// x = A^-1 x in place, in the precision of the factor. Gives the same bytes with any number of threads.
    void solve(std::span<Vec6> x, const ThreadPool& pool);
    void solve(std::span<Vec6> x) { solve(x, ThreadPool(1)); }

    const SymbolicFactor& symbolic() const { return symbolic_; }

  private:
    // The work of a front. If the front is large, the threads of the pool share it, but for the entries of
    // the matrix and the squares on the diagonal.
    /// Sets the panel of a front to the entries of the matrix.
    void assemble_panel(const BlockMatrix& matrix, std::size_t f, const ThreadPool& pool);
    // Extend-add of the children's updates, and of block column j of that of child `c`. Updates inside a
    // subtree are in `space`.
    void add_column_to_panel(const Front& front, int c, std::size_t j, Scalar* space);
    void add_column_to_update(const Front& front, int c, std::size_t j, Scalar* space);
    void add_updates_to_panel(std::size_t f, Scalar* space, const ThreadPool& pool);
    void add_updates_to_update(std::size_t f, Scalar* space, const ThreadPool& pool);
    /// Marks the fronts to be factorised again.
    void find_outdated(std::span<const char> changed);
    /// L11 of a front. @return false when it is not positive definite.
    bool factor_pivots(const Front& front, const ThreadPool& pool);
    /// The dense work of a front.
    bool eliminate(std::size_t f, Scalar* space, const ThreadPool& pool);
    bool factorize_front(std::size_t f, const BlockMatrix& matrix, Scalar* space, const ThreadPool& pool);
    Scalar* update(const Front& front, Scalar* space) {
        return (front.in_subtree ? space : shared_updates_.data()) + front.update;
    }
    Scalar* panel(const Front& front) { return factor_.data() + front.panel; }
    // Substitution: each front has a vector with one entry for each row of its panel. In the forward pass the
    // pivot part is the right-hand side minus the contributions of the descendants, and the rest is the
    // contribution to the ancestors. In the backward pass it is the solution.
    void solve_forward(std::size_t f, std::span<const Vec6> b);
    void solve_backward(std::size_t f, std::span<Vec6> solution);
    Scalar* vector(std::size_t f) { return vectors_.data() + vector_begin_[f]; }
    static auto block(Scalar* x, int k) { return Eigen::Map<Eigen::Matrix<Scalar, 6, 1>>(x + 6 * k); }
    std::size_t row_of_pivot(const Front& front, int k) const {
        const int column = front.first + k;
        return symbolic_.order[column];
    }

    const FrontKernels<Scalar>& kernels_ = chosen_front_kernels<Scalar>();
    SymbolicFactor symbolic_;
    bool has_factor_ = false;
    std::vector<char> outdated_;  ///< per front, whether it has to be factorised again
    AlignedBuffer<Scalar> factor_;
    AlignedBuffer<Scalar> shared_updates_;
    AlignedBuffer<Scalar> subtree_updates_;  ///< subtree_space scalars for each thread
    std::vector<std::size_t> vector_begin_;  ///< per front, offset of its vector in `vectors_`
    AlignedBuffer<Scalar> vectors_;          ///< of the substitutions
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace rockslope::dda
