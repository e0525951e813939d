#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A run tells of a block that is inside another one by more than this fraction of the smaller block's size,
/// the square root of its area: its contact is too soft for the load, or did not hold it.
inline constexpr double deep_share = 0.01;

/// Notes in the state the deepest contact so far, by its penetration over the size of the smaller block. The
/// contraction of a rough joint is no penetration.
void note_deepest_contact(const Model& model, State& state);

}  // namespace rockslope::dda
