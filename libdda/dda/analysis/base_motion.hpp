#pragma once

#include <vector>

#include "dda/block/block_system.hpp"
#include "dda/model/stage.hpp"

namespace dda {

/// The displacement over a step of every block whose motion is known, and its acceleration at the step's end;
/// zero for free blocks. A base motion gives accelerations: the displacement is built by the engine's own
/// integration, u = dt v0 + dt^2 a / 2, so that the block's acceleration is the record itself. Outside its
/// table, and in static stages, the acceleration is zero.
struct PrescribedMotion {
    std::vector<Vec6> displacement;  ///< per block
    std::vector<Vec6> acceleration;  ///< per block
};

/// @param stage_time s, at the step's end, since the start of the stage.
PrescribedMotion prescribe_motion(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                  double dt, double stage_time);

}  // namespace dda
