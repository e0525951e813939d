#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/linear/block_matrix.hpp"
#include "dda/linear/solver_kind.hpp"

namespace rockslope::dda {

/// Relative residual |b - A x| / |b| of a full solution, in the norm |v|^2 = sum v_i^2 / A_ii. A factor in
/// double precision leaves as much on walls with springs of 100 E.
inline constexpr double full_tolerance = 1e-11;

/// Solves the symmetric positive definite system A x = b of a step. Keeps its work space between steps.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;
    /// Orders the blocks and factorises symbolically. Called only when the pattern changes.
    virtual void analyze(const BlockPattern& pattern) = 0;
    /// Factorises. @return false when the matrix is not positive definite (the caller rejects the step).
    /// @param matrix must not change until the last solution with this factor.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Factorises a matrix that differs from the last one only in the rows and columns marked in `changed`.
    /// @param changed per row, non-zero where the matrix may differ; empty: everywhere.
    virtual bool refactorize(const BlockMatrix& matrix, std::span<const char> /*changed*/) {
        return factorize(matrix);
    }
    /// Solves with the current factor to `full_tolerance`, in place.
    virtual void solve(std::vector<Vec6>& right_hand_side) = 0;

    /// Number of factorisations repeated in double precision, since the solver was made, because single
    /// precision failed.
    virtual int fallbacks() const { return 0; }

    // A caller that changes b during the solution calls three functions: solve_coarsely for a first iterate,
    // apply_factor for each direction that is added to it, refine to remove the rounding error of the sum.
    // By default solve_coarsely is already exact and refine does nothing.
    /// Improves x until |b - A x| <= 1e-7 |b|, starting from the x passed. @return number of substitutions.
    virtual int solve_coarsely(std::vector<Vec6>& x, const std::vector<Vec6>& b) {
        x = b;
        solve(x);
        return 1;
    }
    /// Solves in place by one substitution, to the precision of the factor.
    virtual void apply_factor(std::vector<Vec6>& right_hand_side) { solve(right_hand_side); }
    /// Improves x until |b - A x| <= tolerance |b|; `full_tolerance` is as accurate as `solve`.
    /// @return number of substitutions; zero if x meets the tolerance already.
    virtual int refine(std::vector<Vec6>& /*x*/, const std::vector<Vec6>& /*b*/, double /*tolerance*/) {
        return 0;
    }
};

/// @param pool outlives the solver.
std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind, const ThreadPool& pool);

/// A factor of at most this many 6x6 submatrices, some five hundred blocks, is in double precision. For
/// smaller ones refinement costs as much as single precision saves.
inline constexpr double double_precision_limit = 8e3;

/// Multifrontal Cholesky factorisation, see multifrontal_factor.hpp. Small systems are factorised in double
/// precision, larger ones in single precision with refinement, see refined_factor.hpp. Gives the same bytes
/// with any number of threads.
/// @param pool outlives the solver. @param max_submatrices largest factor that is kept in double precision.
std::unique_ptr<LinearSolver> make_multifrontal_solver(const ThreadPool& pool,
                                                       double max_submatrices = double_precision_limit);

/// Eigen's simplicial Cholesky factorisation, ordered by fill_reducing_order. Gives the same bytes on any
/// processor.
std::unique_ptr<LinearSolver> make_simplicial_solver();

/// Fill-reducing order of a block graph: order[k] is the block eliminated k-th. Nested dissection by METIS
/// with a fixed seed, then a postorder of the elimination tree, which makes each subtree contiguous.
/// @throws std::runtime_error when METIS fails.
std::vector<int> fill_reducing_order(const BlockPattern& pattern);

}  // namespace rockslope::dda
