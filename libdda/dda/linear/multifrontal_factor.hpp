#pragma once

#include <span>
#include <vector>

#include "dda/base/parallel.hpp"
#include "dda/linear/aligned_buffer.hpp"
#include "dda/linear/front_plan.hpp"

namespace dda {

/// Cholesky factorisation of a symmetric block matrix by fronts: dense work only, the subtrees of the
/// assembly tree shared among threads. The factor is the same bytes with any number of threads. [Duff & Reid
/// 1983]
/// @tparam Scalar float or double: of the factor, the matrix is always double.
template <class Scalar>
class MultifrontalFactor {
  public:
    /// Lays out the fronts and takes the memory that the factorisation needs.
    void analyze(const BlockPattern& pattern, const SupernodeTree& tree,
                 std::size_t most_kept = most_kept_updates);
    /// @param changed per row, where the matrix may differ from the last one, with the columns of that index;
    /// empty: everywhere. Where updates are kept only fronts above such rows are worked through, to the same
    /// bytes.
    /// @return false when the matrix is not positive definite in this precision; there is no factor then.
    bool factorize(const BlockMatrix& matrix, const Crew& crew, std::span<const char> changed = {});
    /// x = A^-1 b in place, with the factor's precision.
    void solve(std::span<Vec6> x);

    const FrontPlan& plan() const { return plan_; }

  private:
    void assemble_panel(const BlockMatrix& matrix, std::size_t f);
    // In a subtree, updates are in `space`.
    void add_updates_to_panel(std::size_t f, Scalar* space);
    void add_updates_to_update(std::size_t f, Scalar* space);
    /// Which fronts' panels differ from the present factor's.
    void find_outdated(std::span<const char> changed);
    /// The front's dense work; its parts may be shared.
    bool eliminate(std::size_t f, Scalar* space, const Crew& crew);
    bool work_through(std::size_t f, const BlockMatrix& matrix, Scalar* space, const Crew& crew);
    Scalar* update(const Front& front, Scalar* space) {
        return (front.in_subtree ? space : shared_updates_.data()) + front.update;
    }
    Scalar* panel(const Front& front) { return factor_.data() + front.panel; }
    /// The present solution by rows of the front's panel; `scatter` takes it back.
    Scalar* gather(std::size_t f);
    void scatter(std::size_t f);

    FrontPlan plan_;
    bool complete_ = false;       ///< there is a factor
    std::vector<char> outdated_;  ///< per front
    AlignedBuffer<Scalar> factor_;
    AlignedBuffer<Scalar> shared_updates_;
    AlignedBuffer<Scalar> subtree_updates_;  ///< a space for each thread
    AlignedBuffer<Scalar> front_solution_;   ///< by rows of one panel
    std::vector<Scalar> solution_;           ///< by place in the order
};

extern template class MultifrontalFactor<float>;
extern template class MultifrontalFactor<double>;

}  // namespace dda
