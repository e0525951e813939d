#pragma once

#include "dda/analysis/run_observer.hpp"

namespace rockslope::dda {

/// Finds the factor of safety of a state by strength reduction (Zienkiewicz et al. 1975; Matsui & San 1992):
/// the largest factor by which cohesion, tan(phi) and tensile strength of the joints can be divided so that
/// the blocks still come to rest.
///
/// Each trial is a static stage that starts from `state` with the strengths divided by its factor. The trial
/// stands if the blocks settle. It fails if they do not settle within the step limit, if a block moves by
/// more than the displacement limit, or if no step is accepted. Starting from 1, the factor is doubled or
/// halved until one trial stands and another fails. Bisection in the logarithm then narrows this bracket to
/// the width asked for. The observer receives every trial, and at the end the final state of the failed trial
/// with the smallest factor, the mechanism.
///
/// Only the time of `state` changes: it advances by the time of all trials.
/// @return `stopped` when the observer asks for it, otherwise `completed`.
RunOutcome find_factor_of_safety(const Model& model, const Stage& stage, State& state, RunObserver& observer,
                                 int threads);

}  // namespace rockslope::dda
