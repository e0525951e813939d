#pragma once

#include <memory>

#include "dda/linear/linear_solver.hpp"

namespace rockslope::bench {

/// CHOLMOD's supernodal Cholesky factorisation on one thread, ordered by fill_reducing_order: a peer to
/// measure the engine's own factorisation beside.
std::unique_ptr<dda::LinearSolver> make_cholmod_solver();

}  // namespace rockslope::bench
