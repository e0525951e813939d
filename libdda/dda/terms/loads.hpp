#pragma once

#include <functional>

#include "dda/terms/face_points.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// Time and frame acceleration at which loads are evaluated.
struct LoadInstant {
    double time = 0;                         ///< s, sum over the dynamic stages: the time of load histories
    Vec2 frame_acceleration = Vec2::Zero();  ///< m/s2, of the stage's frame of reference
};

/// The generalised forces of all loads except gravity, per row, N (and N m) per metre. Inertia forces of an
/// accelerated frame are included.
PerRow<Vec6> load_forces(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                         const MidStep& mid, const LoadInstant& instant);

/// The generalised forces of one load with its history at 1, per row, N (and N m) per metre.
PerRow<Vec6> unit_load_forces(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                              const MidStep& mid, const Load& load);

/// Adds gravity and all loads.
void add_loads(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
               const LoadInstant& instant, BaseSystem& base);

/// The largest acceleration that a single load with its history at 1 can give a block, m/s2: a scale for
/// unbalanced forces. For a load on faces, the magnitudes of its tractions are summed, whatever their
/// direction.
double max_load_acceleration(const Model& model, const BlockSystem& blocks);

/// A load that pushes a block.
struct Push {
    const char* load = nullptr;  ///< its key in the run model; null: no load does
    double force = 0;            ///< N per metre, along the direction asked for
};

/// The load with the largest force on a block along a direction; none pushes a block without unknowns.
/// @param direction of length 1. @param time s, of the load histories.
Push largest_push(const Model& model, const BlockSystem& blocks, BlockIndex block, const Vec2& direction,
                  double time);

/// Called with each integration point of a face and the traction on the rock there, Pa.
using TractionVisit = std::function<void(const FacePoint& point, const Vec2& traction)>;

/// Visits the tractions of a load on faces with its history at 1, Eqs. (54)-(56).
void visit_tractions(const Model& model, const MidStep& mid, const LineLoad& load,
                     const TractionVisit& visit);
void visit_tractions(const Model& model, const MidStep& mid, const JointWater& load,
                     const TractionVisit& visit);
void visit_tractions(const Model& model, const MidStep& mid, const HeadWater& load,
                     const TractionVisit& visit);

}  // namespace rockslope::dda
