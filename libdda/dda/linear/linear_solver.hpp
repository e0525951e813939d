#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dda/base/parallel.hpp"
#include "dda/linear/block_matrix.hpp"
#include "dda/linear/solver_kind.hpp"

namespace dda {

/// Solves the step's symmetric positive definite system. Work space that outlives the step lives here.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;
    /// Orders and analyses a pattern; called only when the pattern changes.
    virtual void analyze(const BlockPattern& pattern) = 0;
    /// Factorises. @return false when the matrix is not positive definite (the caller rejects the step).
    virtual bool factorize(const BlockMatrix& matrix) = 0;
    /// Likewise, of a matrix that differs from the last one only in rows (and columns) where `changed` says
    /// so.
    /// @param changed per row; empty: all of them.
    virtual bool refactorize(const BlockMatrix& matrix, std::span<const char> /*changed*/) {
        return factorize(matrix);
    }
    /// Solves with the present factor, in place.
    virtual void solve(std::vector<Vec6>& right_hand_side) = 0;
};

/// @param crew outlives the solver.
std::unique_ptr<LinearSolver> make_linear_solver(SolverKind kind, const Crew& crew);

/// Cholesky factorisation by dense fronts, see multifrontal_factor.hpp, in double precision. The same bytes
/// with any number of threads. @param crew outlives the solver.
std::unique_ptr<LinearSolver> make_multifrontal_solver(const Crew& crew);

/// CHOLMOD's supernodal Cholesky factorisation, ordered on the graph of the blocks.
std::unique_ptr<LinearSolver> make_cholmod_solver();

/// A fill-reducing order of a block graph: order[k] is the block eliminated k-th. Nested dissection by METIS,
/// with a fixed seed; the subtrees of the elimination tree are together, as supernodes need it.
std::vector<int> fill_reducing_order(const BlockPattern& pattern);

}  // namespace dda
