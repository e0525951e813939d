#pragma once

#include <memory>

#include "dda/base/parallel.hpp"
#include "dda/linear/linear_solver.hpp"

namespace dda {

/// Cholesky factorisation by dense fronts, see multifrontal_factor.hpp, in double precision. The same bytes
/// with any number of threads. @param crew outlives the solver.
std::unique_ptr<LinearSolver> make_multifrontal_solver(const Crew& crew);

}  // namespace dda
