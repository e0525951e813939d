#pragma once

#include <functional>

#include "dda/terms/face_points.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// What loads depend on besides the blocks.
struct LoadInstant {
    double time = 0;                         ///< s of the run's dynamic stages: the clock of load histories
    Vec2 frame_acceleration = Vec2::Zero();  ///< m/s2, of the frame that a stage is computed in
};

/// The force of all loads but gravity on the unknowns of each row's block, N (and N m) per metre, the inertia
/// forces of an accelerated frame among them.
std::vector<Vec6> load_forces(const Model& model, const RowMap& rows, const BlockSystem& blocks,
                              const MidStep& mid, const LoadInstant& instant);

/// Adds gravity and all loads.
void add_loads(const Model& model, const RowMap& rows, const BlockSystem& blocks, const MidStep& mid,
               const LoadInstant& instant, BaseSystem& base);

/// The largest acceleration that a single load, its history at 1, could give a block that it acts on, m/s2: a
/// measure for what counts as balanced. Of a load on faces, the sum of all it pushes with, whatever the
/// directions.
double max_load_acceleration(const Model& model, const BlockSystem& blocks);

/// What is called with a face's points and the traction on the rock there, Pa.
using TractionVisit = std::function<void(const FacePoint& point, const Vec2& traction)>;

/// The tractions of the loads that act on faces, Eqs. (54)-(56), their histories at 1.
void visit_tractions(const Model& model, const MidStep& mid, const LineLoad& load,
                     const TractionVisit& visit);
void visit_tractions(const Model& model, const MidStep& mid, const JointWater& load,
                     const TractionVisit& visit);
void visit_tractions(const Model& model, const MidStep& mid, const HeadWater& load,
                     const TractionVisit& visit);

}  // namespace rockslope::dda
