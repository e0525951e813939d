#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// Adds to the velocity of each free block what moves it in one step of the stage by at most the rounding of
/// the largest coordinate, 2^-52 of it, in a direction and by a share that the stage's seed draws. Nothing
/// for the seed 0. A slope whose results change by more than that is chaotic: the runs of several seeds are
/// samples of what it may do.
void perturb(const Model& model, const Stage& stage, State& state);

}  // namespace rockslope::dda
