#pragma once

#include "dda/model/stage.hpp"
#include "dda/terms/free_field.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// What the face of a viscous boundary adds to its block's equations in one step, Eqs. (47)-(50).
struct BoundaryTerm {
    int row = 0;
    Mat6 damping = Mat6::Zero();  ///< times the velocity at the step's end: the dashpots' force, reversed
    Mat6 stiffness =
        Mat6::Zero();           ///< times the displacement: what a static stage holds the face with, reversed
    Vec6 force = Vec6::Zero();  ///< of the incident wave, and of the rock that was taken away
};

/// The forces of the rock behind each face's two points, N per metre: what bore the model at the end of its
/// last static stage. In the order of the model's boundaries and their faces; zero at first.
using BoundaryReactions = std::vector<Vec2>;
BoundaryReactions no_reactions(const Model& model);

/// One term for each face of a free block. Dashpots work in dynamic stages, holding springs in static ones.
/// @param stage_time s, at the step's end; @param fields at the step's end.
std::vector<BoundaryTerm> boundary_terms(const Model& model, const RowMap& rows, const MidStep& mid,
                                         const Stage& stage, double stage_time,
                                         const BoundaryReactions& reactions, const FreeFieldMotions& fields);

void add_boundaries(std::span<const BoundaryTerm> terms, const RowMap& rows, const BlockSystem& blocks,
                    const Newmark& newmark, BaseSystem& base);

/// The reactions after an accepted step. They change in static stages alone.
/// @param displacement per block.
BoundaryReactions advance_reactions(const Model& model, const MidStep& mid, const Stage& stage,
                                    std::span<const Vec6> displacement, BoundaryReactions reactions);

}  // namespace rockslope::dda
