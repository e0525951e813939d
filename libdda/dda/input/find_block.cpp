#include "dda/input/find_block.hpp"

#include <algorithm>

namespace rockslope::dda {

namespace {

const Vec2& vertex(const Model& model, int corner) {
    return model.vertices[static_cast<std::size_t>(corner)];
}
int next_corner(const Model& model, int corner) {
    return model.topology.next[static_cast<std::size_t>(corner)];
}

/// Even-odd rule over all rings, so that holes count as outside.
bool contains(const Model& model, int first, int last, const Vec2& point) {
    bool inside = false;
    for (int corner = first; corner < last; ++corner) {
        const Vec2& a = vertex(model, corner);
        const Vec2& b = vertex(model, next_corner(model, corner));
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        const double crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (crossing > point.x()) inside = !inside;
    }
    return inside;
}

double distance_to_edge(const Vec2& a, const Vec2& b, const Vec2& point) {
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (point - a - share * along).norm();
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

std::optional<int> find_block(const Model& model, const Vec2& point) {
    if (model.vertices.empty()) return std::nullopt;
    const double tolerance = 1e-9 * model_size(model);
    std::optional<int> on_face;
    for (int block = 0; block < model.block_count(); ++block) {
        const int first = model.topology.block_corners[static_cast<std::size_t>(block)];
        const int last = model.topology.block_corners[static_cast<std::size_t>(block) + 1];
        for (int corner = first; corner < last && !on_face; ++corner)
            if (distance_to_edge(vertex(model, corner), vertex(model, next_corner(model, corner)), point) <=
                tolerance)
                on_face = block;
        if (on_face != block && contains(model, first, last, point)) return block;
    }
    return on_face;
}

}  // namespace rockslope::dda
