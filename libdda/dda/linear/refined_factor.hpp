#pragma once

#include <span>
#include <vector>

#include "dda/linear/multifrontal_factor.hpp"

namespace rockslope::dda {

/// A factor in single precision, which takes half the memory of one in double, and conjugate gradients in
/// double precision that it preconditions: solutions are as near as those of a factor in double.
class RefinedFactor {
  public:
    void analyze(const BlockPattern& pattern, const SupernodeTree& tree);
    /// As MultifrontalFactor::factorize. @param matrix must stay as it is until the last solution.
    bool factorize(const BlockMatrix& matrix, const ThreadPool& pool, std::span<const char> changed = {});
    /// x = A^-1 b in place, as nearly as the factor is.
    void apply_factor(std::span<Vec6> x, const ThreadPool& pool) { factor_.solve(x, pool); }
    struct Outcome {
        bool converged = false;  ///< where not, single precision is too little
        int substitutions = 0;
    };
    /// Brings x to A^-1 b from where it is, or from zero where that is nearer.
    /// @param tolerance of b that may be left in the residual, norms scaled by the matrix' diagonal.
    Outcome refine(std::span<Vec6> x, std::span<const Vec6> b, double tolerance, const ThreadPool& pool);

  private:
    /// Norms squared, scaled by the matrix' diagonal.
    struct SquaredNorms {
        double residual = 0;
        double load = 0;
    };
    /// Sets the residual, and x to zero where that leaves less.
    SquaredNorms reset_residual(std::span<Vec6> x, std::span<const Vec6> b, const ThreadPool& pool);

    BlockPattern pattern_;
    const BlockMatrix* matrix_ = nullptr;
    MultifrontalFactor<float> factor_;
    std::vector<Vec6> weight_;  ///< reciprocals of the matrix' diagonal
    std::vector<Vec6> residual_, preconditioned_, direction_, image_;  ///< of the conjugate gradients
};

}  // namespace rockslope::dda
