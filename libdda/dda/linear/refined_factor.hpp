#pragma once

#include <span>
#include <vector>

#include "dda/linear/multifrontal_factor.hpp"

namespace rockslope::dda {

/// Conjugate gradients in double precision, preconditioned by a Cholesky factor in single precision.
/// Solutions are as accurate as those of a factor in double precision, which takes twice the memory.
class RefinedFactor {
  public:
    void analyze(const BlockPattern& pattern, const SupernodeTree& tree);
    /// As MultifrontalFactor::factorize. @param matrix must not change until the last solution.
    bool factorize(const BlockMatrix& matrix, const ThreadPool& pool, std::span<const char> changed = {});
    /// x = A^-1 x in place by one substitution, in single precision.
    void apply_factor(std::span<Vec6> x, const ThreadPool& pool) { factor_.solve(x, pool); }
    struct Outcome {
        bool converged = false;  ///< if not, single precision is not sufficient for this matrix
        int substitutions = 0;
    };
    /// Improves x until |b - A x| <= tolerance |b|, in the norm |v|^2 = sum v_i^2 / A_ii. Starts from the x
    /// passed, or from zero if that has the smaller residual.
    Outcome refine(std::span<Vec6> x, std::span<const Vec6> b, double tolerance, const ThreadPool& pool);

  private:
    /// Squared norms |v|^2 = sum v_i^2 / A_ii.
    struct SquaredNorms {
        double residual = 0;
        double load = 0;
    };
    /// Sets the residual to b - A x. If it is larger than b, sets x to zero and the residual to b.
    SquaredNorms reset_residual(std::span<Vec6> x, std::span<const Vec6> b, const ThreadPool& pool);

    BlockPattern pattern_;
    const BlockMatrix* matrix_ = nullptr;
    MultifrontalFactor<float> factor_;
    std::vector<Vec6> weight_;                                         ///< 1 / A_ii
    std::vector<Vec6> residual_, preconditioned_, direction_, image_;  ///< vectors of conjugate gradients
};

}  // namespace rockslope::dda
