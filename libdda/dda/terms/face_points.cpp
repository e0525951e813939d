#include "dda/terms/face_points.hpp"

#include <numbers>

namespace rockslope::dda {

std::array<FacePoint, 2> face_points(const Model& model, const MidStep& mid, const FacePart& face) {
    const Vec2& first = mid.vertices[start_of(face.edge)];
    const Vec2 along = mid.vertices[model.topology.end_of(face.edge)] - first;
    const double length = along.norm();
    const BlockIndex block = model.topology.block_of_edge(face.edge);
    constexpr double offset = 0.5 * std::numbers::inv_sqrt3;
    std::array<FacePoint, 2> points;
    for (const std::size_t k : {0, 1}) {
        FacePoint& point = points[k];
        point.block = block;
        point.fraction = 0.5 + (k == 0 ? -offset : offset);
        point.weight = (face.to - face.from) * length / 2;
        const double at = face.from + point.fraction * (face.to - face.from);
        point.arm = first + at * along - mid.centroid[block];
        point.tangent = along / length;
        point.normal = -perpendicular(point.tangent);
    }
    return points;
}

}  // namespace rockslope::dda
