#pragma once

#include <vector>

#include "dda/block/block_system.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// The motion over a step of every block whose motion is known; zero for free blocks. A base motion gives
/// accelerations a. The stage's steps end on the instants k h, h the stage's step (a step that is cut has its
/// pieces end there), and from one such instant to the next the block moves by the engine's own integration
/// with the acceleration at the later one, Eq. (40): u += dt v + dt^2 a / 2, v += dt a. So the motion at
/// those instants does not depend on cuts, and the acceleration there is the record itself. Outside its
/// table, and in static stages, the acceleration is zero.
struct PrescribedMotion {
    std::vector<Vec6> displacement;     ///< per block, over the step
    std::vector<Vec6> velocity_change;  ///< per block, over the step
    std::vector<Vec6> acceleration;     ///< per block, the record at the step's end
};

/// The acceleration that a stage gives a prescribed block at an instant, m/s2; zero for others.
Vec2 base_acceleration(const Model& model, const Stage& stage, std::size_t block, double stage_time);

/// The acceleration of the frame that a stage is computed in, m/s2: the sum of its frame motions.
Vec2 frame_acceleration(const Stage& stage, double stage_time);
/// The one that acts over a step: like a base's, that of the next instant k h.
Vec2 frame_acceleration_over_step(const Stage& stage, double dt, double stage_time);

/// @param stage_time s, at the step's end, since the start of the stage.
PrescribedMotion prescribe_motion(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                  double dt, double stage_time);

}  // namespace rockslope::dda
