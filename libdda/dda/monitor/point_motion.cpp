#include "dda/monitor/point_motion.hpp"

#include <algorithm>

namespace rockslope::dda {

std::vector<TrackedPoint> tracked_points(const Model& model) {
    std::vector<TrackedPoint> points;
    for (const MeasuredPointSpec& point : model.measured_points)
        points.push_back({point.name, point.point, BlockIndex::none()});
    for (const BlockIndex block : model.blocks()) {
        if (model.motion[block] != Motion::prescribed) continue;
        const std::string& name = model.block_name[block];
        const auto same = [&](const TrackedPoint& point) {
            return point.block.exists() && point.name == name;
        };
        if (std::none_of(points.begin(), points.end(), same))
            points.push_back({name, PointIndex::none(), block});
    }
    return points;
}

std::optional<std::size_t> find_point(const std::vector<TrackedPoint>& points, const std::string& name) {
    if (name.empty()) return std::nullopt;
    const auto found = std::find_if(points.begin(), points.end(),
                                    [&](const TrackedPoint& point) { return point.name == name; });
    if (found == points.end()) return std::nullopt;
    return found - points.begin();
}

PointMotion motion_of(const Model& model, const State& state, const TrackedPoint& point) {
    const bool measured = point.material_point.exists();
    const PointIndex p = point.material_point;
    const BlockIndex b = measured ? model.material_points[p].block : point.block;
    const Vec2& position = measured ? state.blocks.points[p] : state.blocks.centroid(b);
    const Vec2& origin = measured ? state.displacement_origin[p] : state.centroid_origin[b];
    const Vec2 arm = position - state.blocks.centroid(b);
    const auto t = displacement_matrix(arm);
    const double spin = state.blocks.velocity[b][2];
    return {position - origin, t * state.blocks.velocity[b],
            t * state.blocks.acceleration[b] - spin * spin * arm};
}

}  // namespace rockslope::dda
