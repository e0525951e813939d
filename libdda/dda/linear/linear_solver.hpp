#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/linear/block_matrix.hpp"
#include "dda/linear/solver_kind.hpp"

namespace rockslope::dda {

/// Of the right-hand side, what a solution may leave in the residual, norms scaled by the matrix' diagonal.
/// What a factor in double precision leaves of walls with springs of 100 E is as much.
inline constexpr double full_tolerance = 1e-11;

/// Solves the step's symmetric positive definite system. Work space that outlives the step lives here.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;
    /// Orders and analyses a pattern; called only when the pattern changes.
    virtual void analyze(const BlockPattern& pattern) = 0;
    /// Factorises. @return false when the matrix is not positive definite (the caller rejects the step).
    /// @param matrix stays as it is until the last solution.
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Likewise, of a matrix that differs from the last one only in rows (and columns) where `changed` says
    /// so.
    /// @param changed per row; empty: all of them.
    virtual bool refactorize(const BlockMatrix& matrix, std::span<const char> /*changed*/) {
        return factorize(matrix);
    }
    /// Solves with the present factor, in place.
    virtual void solve(std::vector<Vec6>& right_hand_side) = 0;

    /// How many factors, since the solver was made, were made again in double precision because single was
    /// too little.
    virtual int fallbacks() const { return 0; }

    // A solution in three strokes, for those who change b meanwhile: near enough to judge it, directions to
    // add to it, and what rounding has left taken away. Here the first is exact and leaves nothing to do.
    /// Brings x to A^-1 b, to a residual of a hundred-thousandth of b. @return substitutions taken.
    virtual int solve_coarsely(std::vector<Vec6>& x, const std::vector<Vec6>& b) {
        x = b;
        solve(x);
        return 1;
    }
    /// Solves in place by one substitution, to as many digits as the factor has.
    virtual void apply_factor(std::vector<Vec6>& right_hand_side) { solve(right_hand_side); }
    /// Brings x, put together from these, to A^-1 b, to a residual of that tolerance of b: `full_tolerance`
    /// is as near as `solve`. @return substitutions taken; none where x is as near already.
    virtual int refine(std::vector<Vec6>& /*x*/, const std::vector<Vec6>& /*b*/, double /*tolerance*/) {
        return 0;
    }
};

/// @param pool outlives the solver.
std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind, const ThreadPool& pool);

/// 6x6 submatrices of a factor up to which it is in double precision: some five hundred blocks. Of less than
/// that, what refining takes is as much as what a factor in single precision saves.
inline constexpr double double_precision_limit = 8e3;

/// Cholesky factorisation by dense fronts, see multifrontal_factor.hpp: of small systems in double precision,
/// of others in single precision, refined, see refined_factor.hpp. The same bytes with any number of threads.
/// @param pool outlives the solver. @param max_submatrices up to which a factor is in double precision.
std::unique_ptr<LinearSolver> make_multifrontal_solver(const ThreadPool& pool,
                                                       double max_submatrices = double_precision_limit);

/// CHOLMOD's supernodal Cholesky factorisation, ordered on the graph of the blocks.
std::unique_ptr<LinearSolver> make_cholmod_solver();

/// A fill-reducing order of a block graph: order[k] is the block eliminated k-th. Nested dissection by METIS,
/// with a fixed seed; the subtrees of the elimination tree are together, as supernodes need it.
std::vector<int> fill_reducing_order(const BlockPattern& pattern);

}  // namespace rockslope::dda
