#pragma once

#include <vector>

#include "dda/model/stage.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// The motion of a free-field column, per node from the foot up.
struct ColumnMotion {
    std::vector<Vec2> displacement;  ///< m, since the dynamic stages' start
    std::vector<Vec2> velocity;
    std::vector<Vec2> acceleration;
};
/// Per viscous boundary of the model; empty where there is no column beside it.
using FreeFieldMotions = std::vector<ColumnMotion>;

FreeFieldMotions fields_at_rest(const Model& model);

/// The columns one step later, Eqs. (51) and (52): linear elements with the engine's integration, dashpots
/// and incident wave at the foot, the damping of the blocks beside them. The model does not act on them.
/// Static stages have them at rest. @param blocks beside the columns; @param stage_time s, at the step's end.
FreeFieldMotions advance_fields(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                const FreeFieldMotions& before, double stage_time, const Newmark& newmark);

/// What a column does at a height.
struct FieldPoint {
    Vec2 velocity = Vec2::Zero();  ///< m/s
    Vec2 traction = Vec2::Zero();  ///< Pa, on a plane whose normal is +x: (sigma_x, tau_xy)
};
/// @param height m, within the column; beyond its ends, what is there.
FieldPoint field_at(const Model& model, const FreeField& field, const ColumnMotion& motion, double height);

/// What enters through a boundary of that name: a velocity and a traction, to be doubled by those who let it
/// in, Eq. (48).
struct IncidentMotion {
    Vec2 velocity = Vec2::Zero();  ///< m/s
    Vec2 traction = Vec2::Zero();  ///< Pa, with which the wave pushes the rock
};
IncidentMotion incident_motion(const Stage& stage, const std::string& boundary, double stage_time);

}  // namespace rockslope::dda
