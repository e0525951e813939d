#pragma once

#include "dda/block/block_system.hpp"

namespace rockslope::dda {

/// The configuration at mid-step, predicted from the velocities; that of prescribed blocks is known. Lever
/// arms and contact directions are taken here. The linear displacement of a contact point then agrees with
/// the finite rotation to third order in the step. The work of contact forces equals the energy that they
/// store, and a pair of forces has no resultant moment.
struct MidStep {
    PerCorner<Vec2> vertices;  ///< m
    PerPoint<Vec2> points;     ///< m
    PerBlock<Vec2> centroid;   ///< m
};

/// @param displacement the predicted displacement of the whole step.
MidStep predict_mid_step(const Model& model, const BlockSystem& blocks, BlockSpan<const Vec6> displacement,
                         const ThreadPool& pool);

}  // namespace rockslope::dda
