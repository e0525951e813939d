#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The motion of a point of the rock at one instant, SI.
struct PointMotion {
    Vec2 displacement = Vec2::Zero();  ///< since displacements were last zeroed
    Vec2 velocity = Vec2::Zero();
    Vec2 acceleration = Vec2::Zero();
};

/// A point or block whose motion is recorded: every measured point, then every prescribed block (its
/// centroid) by name.
struct TrackedPoint {
    std::string name;
    PointIndex material_point = PointIndex::none();  ///< of a measured point
    BlockIndex block = BlockIndex::none();           ///< of a prescribed block
};

std::vector<TrackedPoint> tracked_points(const Model& model);
/// Index of the first point with that name; nothing if the name is empty or unknown.
std::optional<std::size_t> find_point(const std::vector<TrackedPoint>& points, const std::string& name);
PointMotion motion_of(const Model& model, const State& state, const TrackedPoint& point);

}  // namespace rockslope::dda
