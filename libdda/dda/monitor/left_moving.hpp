#pragma once

#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// A block that still moved when a static stage ended, see Stage::moving_share.
struct LeftMoving {
    int stage = 0;  ///< index of the stage
    BlockIndex block;
    Vec2 centroid = Vec2::Zero();  ///< m, in the user's coordinates
    double mass = 0;               ///< kg per metre
    double share = 0;              ///< of the mass of all free blocks
    double displacement = 0;       ///< m, of the centroid in the stage
};

/// The blocks that still move at the end of a static stage.
std::vector<LeftMoving> left_moving(const Model& model, const State& state, const Stage& stage,
                                    int stage_index);

}  // namespace rockslope::dda
