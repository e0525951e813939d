#pragma once

#include <vector>

#include "dda/model/stage.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// An instant of a stage.
struct StageInstant {
    const Stage& stage;
    double time;  ///< s, since the start of the stage
};

/// The motion of a free-field column, per node from the base up.
struct ColumnMotion {
    std::vector<Vec2> displacement;  ///< m, since the start of the dynamic stages
    std::vector<Vec2> velocity;      ///< m/s
    std::vector<Vec2> acceleration;  ///< m/s2
};
/// The motion of the column beside each viscous boundary; empty for a boundary without a column.
using FreeFieldMotions = std::vector<ColumnMotion>;

FreeFieldMotions fields_at_rest(const Model& model);

/// Advances the free-field columns by one step, Eqs. (51) and (52): linear elements with the same Newmark
/// integration and damping as the blocks beside them, and dashpots and incident wave at the base. The blocks
/// do not act on the columns. Columns are at rest in static stages.
/// @param end of the step; @param blocks provide the damping.
FreeFieldMotions advance_fields(const Model& model, const StageInstant& end, const BlockSystem& blocks,
                                const FreeFieldMotions& before, const Newmark& newmark);

/// Velocity and traction of a column at a height.
struct FieldPoint {
    Vec2 velocity = Vec2::Zero();  ///< m/s
    Vec2 traction = Vec2::Zero();  ///< Pa, on a plane whose normal is +x: (sigma_x, tau_xy)
};
/// @param height m; clamped to the ends of the column.
FieldPoint field_at(const Model& model, const FreeField& field, const ColumnMotion& motion, double height);

/// The incident wave at a boundary. Eq. (48) doubles it at a dashpot.
struct IncidentMotion {
    Vec2 velocity = Vec2::Zero();  ///< m/s, particle velocity of the wave
    Vec2 traction = Vec2::Zero();  ///< Pa, traction of the wave on the rock
};
/// The sum of the stage's incident waves at the boundary named `boundary`.
IncidentMotion incident_motion(const StageInstant& instant, const std::string& boundary);

}  // namespace rockslope::dda
