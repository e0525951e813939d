#pragma once

#include "dda/model/stage.hpp"
#include "dda/terms/free_field.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// The contribution of one face of a viscous boundary to the equations of its block, Eqs. (47)-(50). The
/// force on the block is force - damping * velocity - stiffness * displacement.
struct BoundaryTerm {
    RowIndex row;
    Mat6 damping = Mat6::Zero();    ///< dashpots; the velocity is that at the end of the step
    Mat6 stiffness = Mat6::Zero();  ///< springs that hold the face in static stages
    Vec6 force = Vec6::Zero();      ///< incident wave, and reactions of the rock beyond the boundary
};

/// The reactions of the rock beyond the boundary, N per metre, at the two integration points of each face:
/// they balance the model at the end of its last static stage. Ordered as the model's boundaries and their
/// faces.
using BoundaryReactions = std::vector<Vec2>;
/// Zero reactions, as at the start of a run.
BoundaryReactions no_reactions(const Model& model);

/// One term for each face of a free block. Dashpots act in dynamic stages, springs in static stages.
/// @param end of the step; @param fields at the end of the step.
std::vector<BoundaryTerm> boundary_terms(const Model& model, const RowMap& rows, const MidStep& mid,
                                         const StageInstant& end, const BoundaryReactions& reactions,
                                         const FreeFieldMotions& fields);

void add_boundaries(std::span<const BoundaryTerm> terms, const RowMap& rows, const BlockSystem& blocks,
                    const Newmark& newmark, BaseSystem& base);

/// The reactions after an accepted step. They change only in static stages.
/// @param displacement per block.
BoundaryReactions advance_reactions(const Model& model, const MidStep& mid, const Stage& stage,
                                    BlockSpan<const Vec6> displacement, BoundaryReactions reactions);

}  // namespace rockslope::dda
