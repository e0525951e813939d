#pragma once

#include "dda/block/block_system.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// The motion of the prescribed blocks over a step; zero for free blocks. A base motion gives their
/// acceleration a. Steps end on the instants k h, where h is the step of the stage; a step that was cut ends
/// there with its last piece. Between two such instants a block moves with the acceleration at the later one:
/// u += dt v + dt^2 a / 2, v += dt a, Eq. (40). The motion at k h therefore does not depend on cuts, and the
/// acceleration there is the record's. The acceleration is zero outside the table and in static stages.
struct PrescribedMotion {
    PerBlock<Vec6> displacement;     ///< per block, over the step
    PerBlock<Vec6> velocity_change;  ///< per block, over the step
    PerBlock<Vec6> acceleration;     ///< per block, value of the record at the end of the step
};

/// The acceleration of a prescribed block at time `stage_time` of the stage, m/s2; zero for other blocks.
Vec2 base_acceleration(const Model& model, const Stage& stage, BlockIndex block, double stage_time);

/// The acceleration of the stage's frame of reference, m/s2: the sum of its frame motions.
Vec2 frame_acceleration(const Stage& stage, double stage_time);
/// The constant frame acceleration of a step that ends at `stage_time`, m/s2. Its value is that at the first
/// instant k h not before the step's end, as for a base motion.
Vec2 frame_acceleration_over_step(const Stage& stage, double dt, double stage_time);

/// The motion of all prescribed blocks over a step.
/// @param dt s, the step; @param stage_time s, since the start of the stage, at the end of the step.
PrescribedMotion prescribe_motion(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                  double dt, double stage_time);

}  // namespace rockslope::dda
