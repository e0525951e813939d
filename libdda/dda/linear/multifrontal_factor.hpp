#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/linear/aligned_buffer.hpp"
#include "dda/linear/front_kernels.hpp"
#include "dda/linear/symbolic_factor.hpp"

namespace rockslope::dda {

/// Scalars of a factor up to which its substitutions are not shared: some 70 us of work.
inline constexpr std::size_t min_parallel_factor_size = std::size_t{1} << 19;

/// Cholesky factorisation of a symmetric block matrix by fronts: dense work only, the subtrees of the
/// assembly tree shared among threads. The factor is the same bytes with any number of threads. [Duff & Reid
/// 1983]
/// @tparam Scalar float or double: of the factor, the matrix is always double.
template <class Scalar>
class MultifrontalFactor {
  public:
    /// Lays out the fronts and takes the memory that the factor needs.
    void analyze(const BlockPattern& pattern, const SupernodeTree& tree,
                 std::size_t max_kept = max_kept_updates);
    /// @param changed per row, where the matrix may differ from the last one, with the columns of that index;
    /// empty: everywhere. Where updates are kept only fronts above such rows are worked through, to the same
    /// bytes.
    /// @return false when the matrix is not positive definite in this precision; there is no factor then.
    bool factorize(const BlockMatrix& matrix, const ThreadPool& pool, std::span<const char> changed = {});
    /// x = A^-1 b in place, with the factor's precision; the same bytes with any number of threads.
    void solve(std::span<Vec6> x, const ThreadPool& pool);
    void solve(std::span<Vec6> x) { solve(x, ThreadPool(1)); }

    const SymbolicFactor& symbolic() const { return symbolic_; }

  private:
    void assemble_panel(const BlockMatrix& matrix, std::size_t f);
    // In a subtree, updates are in `space`.
    void add_updates_to_panel(std::size_t f, Scalar* space);
    void add_updates_to_update(std::size_t f, Scalar* space);
    /// Which fronts' panels differ from the present factor's.
    void find_outdated(std::span<const char> changed);
    /// The front's dense work; its parts may be shared.
    bool eliminate(std::size_t f, Scalar* space, const ThreadPool& pool);
    bool factorize_front(std::size_t f, const BlockMatrix& matrix, Scalar* space, const ThreadPool& pool);
    Scalar* update(const Front& front, Scalar* space) {
        return (front.in_subtree ? space : shared_updates_.data()) + front.update;
    }
    Scalar* panel(const Front& front) { return factor_.data() + front.panel; }
    // Substitution: each front has a vector by the rows of its panel. Going up, its pivots' part is the load
    // less what the fronts below take from it, and the rest what they and this one take from the rows above;
    // going down, it is the solution.
    void solve_forward(std::size_t f, std::span<const Vec6> b);
    void solve_backward(std::size_t f, std::span<Vec6> solution);
    Scalar* vector(std::size_t f) { return vectors_.data() + vector_begin_[f]; }
    static auto block(Scalar* x, int k) { return Eigen::Map<Eigen::Matrix<Scalar, 6, 1>>(x + 6 * k); }
    std::size_t row_of_pivot(const Front& front, int k) const {
        const int column = front.first + k;
        return static_cast<std::size_t>(symbolic_.order[static_cast<std::size_t>(column)]);
    }

    const FrontKernels<Scalar>& kernels_ = front_kernels<Scalar>().front();
    SymbolicFactor symbolic_;
    bool has_factor_ = false;     ///< there is a factor
    std::vector<char> outdated_;  ///< per front
    AlignedBuffer<Scalar> factor_;
    AlignedBuffer<Scalar> shared_updates_;
    AlignedBuffer<Scalar> subtree_updates_;  ///< a space for each thread
    std::vector<std::size_t> vector_begin_;  ///< per front
    AlignedBuffer<Scalar> vectors_;
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace rockslope::dda
