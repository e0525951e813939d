#include <algorithm>

#include "dda/terms/loads.hpp"

namespace rockslope::dda {

namespace {

/// Height of the head line, m: linear between its points, level beyond its ends.
double head_at(const std::vector<Vec2>& head, double x) {
    if (x <= head.front().x()) return head.front().y();
    if (x >= head.back().x()) return head.back().y();
    const auto upper =
        std::upper_bound(head.begin(), head.end(), x, [](double at, const Vec2& p) { return at < p.x(); });
    const Vec2& a = *(upper - 1);
    const double fraction = (x - a.x()) / (upper->x() - a.x());
    return a.y() + fraction * (upper->y() - a.y());
}

/// The fractions of an edge between which the head line is linear, ascending, with both ends of the edge.
std::vector<double> linear_pieces(const std::vector<Vec2>& head, const Vec2& p, const Vec2& q) {
    std::vector<double> fractions = {0, 1};
    for (const Vec2& bend : head) {
        const double fraction = (bend.x() - p.x()) / (q.x() - p.x());
        if (fraction > 0 && fraction < 1) fractions.push_back(fraction);
    }
    std::sort(fractions.begin(), fractions.end());
    return fractions;
}

/// The wet part of an edge piece over which the depth below the head line is linear. Both depths are zero if
/// the piece is dry.
struct WetPart {
    FacePart face;
    double from = 0;  ///< m, depth where the part begins
    double to = 0;    ///< m, depth where it ends
};
WetPart wet_part(EdgeIndex edge, double from, double to, double depth_from, double depth_to) {
    WetPart part{{edge, from, to}, std::max(depth_from, 0.0), std::max(depth_to, 0.0)};
    const double waterline = from + (to - from) * depth_from / (depth_from - depth_to);
    if (depth_from < 0 && depth_to > 0) part.face.from = waterline;
    if (depth_from > 0 && depth_to < 0) part.face.to = waterline;
    return part;
}

}  // namespace

void visit_tractions(const Model& model, const MidStep& mid, const JointWater& load,
                     const TractionVisit& visit) {
    for (const EdgeIndex edge : load.edges) {
        for (const FacePoint& point : face_points(model, mid, {edge, 0, 1}))
            visit(point, -load.pressure * point.normal);
    }
}

void visit_tractions(const Model& model, const MidStep& mid, const HeadWater& load,
                     const TractionVisit& visit) {
    for (const EdgeIndex edge : load.edges) {
        const Vec2& p = mid.vertices[start_of(edge)];
        const Vec2& q = mid.vertices[model.topology.end_of(edge)];
        const auto depth = [&](double fraction) {
            const Vec2 at = p + fraction * (q - p);
            return head_at(load.head, at.x()) - at.y();
        };
        const std::vector<double> fractions = linear_pieces(load.head, p, q);
        for (std::size_t k = 0; k + 1 < fractions.size(); ++k) {
            const WetPart wet =
                wet_part(edge, fractions[k], fractions[k + 1], depth(fractions[k]), depth(fractions[k + 1]));
            if (wet.from <= 0 && wet.to <= 0) continue;
            for (const FacePoint& point : face_points(model, mid, wet.face)) {
                const double below = wet.from + point.fraction * (wet.to - wet.from);
                // The pressure of Eq. (55).
                visit(point, -load.unit_weight * below * point.normal);
            }
        }
    }
}

}  // namespace rockslope::dda
