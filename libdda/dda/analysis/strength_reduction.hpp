#pragma once

#include "dda/analysis/run.hpp"

namespace rockslope::dda {

/// The factor of safety of a state: the largest factor that the joints' strengths, c, tan(phi) and the
/// tensile strength, can be divided by so that the blocks still come to rest (strength reduction, Zienkiewicz
/// et al. 1975; Matsui & San 1992).
///
/// Each trial is a static stage that starts from `state` with strengths divided by its factor. It stands when
/// it settles, and has failed when it does not within the step limit, or a block has moved by more than the
/// displacement limit. Factors double or halve from 1 until one stands and the next fails, and the bracket is
/// then halved, in ratio, down to its width. Each trial is told to the observer.
///
/// The state stays as it was but for its clock, which goes on past the trials'; the first trial that fails,
/// the one with the smallest factor, is the mechanism told last.
/// @return `stopped` when the observer asks for it, otherwise `completed`.
RunOutcome find_factor_of_safety(const Model& model, const Stage& stage, State& state, RunObserver& observer,
                                 int threads);

}  // namespace rockslope::dda
