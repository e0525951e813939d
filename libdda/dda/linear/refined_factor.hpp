#pragma once

#include <span>
#include <vector>

#include "dda/linear/multifrontal_factor.hpp"

namespace dda {

/// A factor in single precision, which takes half the memory of one in double, and conjugate gradients in
/// double precision that it preconditions: solutions are as near as those of a factor in double.
class RefinedFactor {
  public:
    void analyze(const BlockPattern& pattern, const SupernodeTree& tree);
    /// As MultifrontalFactor::factorize. @param matrix must stay as it is until the last solution.
    bool factorize(const BlockMatrix& matrix, const Crew& crew, std::span<const char> changed = {});
    /// x = A^-1 b in place. Starts from a solution before where that is nearer than nothing.
    /// @return false where single precision is too little; x is b then.
    bool solve(std::span<Vec6> x, const Crew& crew);

  private:
    double scaled_square(std::span<const Vec6> v) const;
    /// Sets where the iterations begin. @param whole scaled_square(b). @return whether at the solution
    /// before.
    bool start(std::span<const Vec6> b, double whole);

    BlockPattern pattern_;
    const BlockMatrix* matrix_ = nullptr;
    MultifrontalFactor<float> factor_;
    std::vector<Vec6> weight_;    ///< reciprocals of the matrix' diagonal
    std::vector<Vec6> solution_;  ///< the last one whose right-hand side was like the one before
    std::vector<Vec6> found_, residual_, refined_, direction_, image_;  ///< of the conjugate gradients
};

}  // namespace dda
