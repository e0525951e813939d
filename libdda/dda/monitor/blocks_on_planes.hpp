#pragma once

#include <span>
#include <string>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/stage.hpp"
#include "record/newmark_block.hpp"

namespace rockslope::dda {

/// A block that rests on one plane of a fixed or prescribed block: Newmark's sliding block.
struct BlockOnPlane {
    BlockIndex block;
    BlockIndex base;                ///< the fixed or prescribed block below it
    Vec2 downhill = Vec2::UnitX();  ///< unit, along the plane; towards +x if the plane is level
    double dip = 0;                 ///< rad, of the plane
    record::PlaneStrength peak, residual;
};

/// The blocks of a state that rest on one plane: at least 95 % of the normal forces on a block come from one
/// plane, to 3 degrees, of one fixed or prescribed block below it. The strength is that of the contacts
/// there. Mohr-Coulomb contacts have cohesion times their length; other laws give their present strength. A
/// block that is glued to its base has no yield coefficient and is left out.
std::vector<BlockOnPlane> find_blocks_on_planes(const Model& model, const State& state);

/// The acceleration of a block by one load with its history at 1, m/s2.
struct LoadOnBlock {
    Vec2 acceleration = Vec2::Zero();
    TimeTable history;
};

/// The loads that act on the block of a plane, each with the resultant of its forces at the blocks' initial
/// positions, Eqs. (54) and (55). Water in the plane itself carries a part of the block's weight.
std::vector<LoadOnBlock> loads_on(const Model& model, const BlockOnPlane& plane);

/// Newmark's yield coefficient: horizontal ground acceleration over g at which the block begins to slide
/// downhill, with adhesion, under gravity and the loads at the start of the shaking.
double yield_coefficient(const Model& model, const BlockOnPlane& plane);

/// Newmark's estimate of the slip, m downhill: slip of the rigid block alone in the dynamic stages up to
/// `dynamic_time`, s, under gravity, all loads and the motion of its base. It begins at rest, does not
/// rotate, and keeps its plane and its loads' directions.
double rigid_slip(const Model& model, std::span<const Stage> stages, const BlockOnPlane& plane,
                  double dynamic_time);

/// What holds or moves the block in the run but not in the estimate: "bolts", "fixed points", "viscous
/// boundaries", "initial velocities".
std::vector<std::string> ignored_by_estimate(const Model& model, const BlockOnPlane& plane);

/// Slip of the block in the run, m: its displacement down the plane relative to its base, from the state at
/// which displacements were last zeroed.
double simulated_slip(const State& state, const BlockOnPlane& plane);

}  // namespace rockslope::dda
