#pragma once

#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Notes in the state the free blocks that have left the ground since they were noted last: all their
/// corners lie lower than any corner of a block that is fixed or prescribed, so that nothing stops their
/// fall. A model without such a block, or without gravity, has no ground. @return the new ones.
std::vector<BlockIndex> note_lost_blocks(const Model& model, State& state);

}  // namespace rockslope::dda
