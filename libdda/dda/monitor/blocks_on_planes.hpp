#pragma once

#include <span>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/stage.hpp"
#include "record/newmark_block.hpp"

namespace rockslope::dda {

/// A block that rests on one plane of rock that moves with the ground, or not at all: Newmark's block.
struct BlockOnPlane {
    int block = 0;
    int base = 0;                   ///< the fixed or prescribed block below it
    Vec2 downhill = Vec2::UnitX();  ///< along the plane; towards +x where it is level
    double dip = 0;                 ///< rad, of the plane
    record::PlaneStrength peak, residual;
};

/// The blocks of a state that rest so: 95 % of the normal forces at a block come from one plane, to 3
/// degrees, of one block that cannot move by itself, and hold it up. Strengths are those of the contacts
/// there: cohesion with their lengths; of a joint law other than Mohr-Coulomb, what it bears at present.
std::vector<BlockOnPlane> find_blocks_on_planes(const Model& model, const State& state);

/// Horizontal acceleration of the ground, over g, at which the block begins to slide downhill: Newmark's
/// yield coefficient, with the adhesion.
double yield_coefficient(const BlockOnPlane& plane, double gravity);

/// Newmark's estimate, m downhill: how far the block, taken as rigid and alone, slides in the dynamic stages
/// up to `dynamic_time` under gravity, body loads and the motion of its base.
double rigid_slip(const Model& model, std::span<const Stage> stages, const BlockOnPlane& plane,
                  double dynamic_time);

/// The same in the run: the block's displacement down the plane, relative to its base, m, since displacements
/// count.
double simulated_slip(const State& state, const BlockOnPlane& plane);

}  // namespace rockslope::dda
