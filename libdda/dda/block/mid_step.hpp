#pragma once

#include <vector>

#include "dda/block/block_system.hpp"

namespace rockslope::dda {

/// The configuration half-way through a step, predicted from the velocities (for prescribed blocks: known).
/// Lever arms and contact directions are taken here: then the linear displacement of a contact point agrees
/// with that of the exact rotation to third order in the step, so that the work of contact forces is the
/// energy they store, and a pair of forces leaves no moment.
struct MidStep {
    std::vector<Vec2> vertices;  ///< per corner, m
    std::vector<Vec2> points;    ///< per material point, m
    std::vector<Vec2> centroid;  ///< per block, m
};

/// @param displacement per block, the predicted displacement of the whole step.
MidStep predict_mid_step(const Model& model, const BlockSystem& blocks, std::span<const Vec6> displacement,
                         const ThreadPool& pool);

}  // namespace rockslope::dda
