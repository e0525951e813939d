#pragma once

#include <span>
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
/// there. Mohr-Coulomb contacts have cohesion times their length; other laws give their present strength.
std::vector<BlockOnPlane> find_blocks_on_planes(const Model& model, const State& state);

/// Newmark's yield coefficient: horizontal ground acceleration over g at which the block begins to slide
/// downhill, with adhesion. @param gravity m/s2.
double yield_coefficient(const BlockOnPlane& plane, double gravity);

/// Newmark's estimate of the slip, m downhill: slip of the rigid block alone in the dynamic stages up to
/// `dynamic_time`, s, under gravity, body loads and the motion of its base.
double rigid_slip(const Model& model, std::span<const Stage> stages, const BlockOnPlane& plane,
                  double dynamic_time);

/// Slip of the block in the run, m: its displacement down the plane relative to its base, from the state at
/// which displacements were last zeroed.
double simulated_slip(const State& state, const BlockOnPlane& plane);

}  // namespace rockslope::dda
