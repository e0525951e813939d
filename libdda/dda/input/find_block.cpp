#include <algorithm>

#include "dda/input/read_loads.hpp"

namespace rockslope::dda {

namespace {

/// Even-odd rule over all rings: a point in a hole is outside.
bool contains(const Model& model, BlockIndex block, const Vec2& point) {
    bool inside = false;
    for (const CornerIndex corner : model.topology.corners_of(block)) {
        const Vec2& a = model.vertices[corner];
        const Vec2& b = model.vertices[model.topology.next[corner]];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        const double crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (crossing > point.x()) inside = !inside;
    }
    return inside;
}

double distance_to_edge(const Vec2& a, const Vec2& b, const Vec2& point) {
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double fraction = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (point - a - fraction * along).norm();
}

double model_size(const Model& model) {
    Vec2 low = model.vertices.front(), high = low;
    for (const Vec2& v : model.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    return (high - low).norm();
}

}  // namespace

std::optional<BlockIndex> find_block(const Model& model, const Vec2& point) {
    if (model.vertices.empty()) return std::nullopt;
    const double tolerance = 1e-9 * model_size(model);
    std::optional<BlockIndex> on_face;
    for (const BlockIndex block : model.blocks()) {
        for (const CornerIndex corner : model.topology.corners_of(block)) {
            const Vec2& next = model.vertices[model.topology.next[corner]];
            if (!on_face && distance_to_edge(model.vertices[corner], next, point) <= tolerance)
                on_face = block;
        }
        if (on_face != block && contains(model, block, point)) return block;
    }
    return on_face;
}

}  // namespace rockslope::dda
