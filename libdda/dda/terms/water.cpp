#include <algorithm>

#include "dda/terms/loads.hpp"

namespace dda {

namespace {

/// Height of the head line, m: linear between its points, level beyond its ends.
double head_at(const std::vector<Vec2>& head, double x) {
    if (x <= head.front().x()) return head.front().y();
    if (x >= head.back().x()) return head.back().y();
    const auto upper =
        std::upper_bound(head.begin(), head.end(), x, [](double at, const Vec2& p) { return at < p.x(); });
    const Vec2& a = *(upper - 1);
    const double share = (x - a.x()) / (upper->x() - a.x());
    return a.y() + share * (upper->y() - a.y());
}

/// Where the head line bends above an edge, as shares of the edge, in order, with both its ends.
std::vector<double> pieces_of(const std::vector<Vec2>& head, const Vec2& p, const Vec2& q) {
    std::vector<double> shares = {0, 1};
    for (const Vec2& bend : head) {
        const double share = (bend.x() - p.x()) / (q.x() - p.x());
        if (share > 0 && share < 1) shares.push_back(share);
    }
    std::sort(shares.begin(), shares.end());
    return shares;
}

/// The wet part of a piece over which depth below the head is linear: none where both ends are dry.
struct WetPart {
    FacePart face;
    double from = 0;  ///< m, depth where the part begins
    double to = 0;    ///< m, depth where it ends
};
WetPart wet_part(int edge, double from, double to, double depth_from, double depth_to) {
    WetPart part{{edge, from, to}, std::max(depth_from, 0.0), std::max(depth_to, 0.0)};
    const double shore = from + (to - from) * depth_from / (depth_from - depth_to);
    if (depth_from < 0 && depth_to > 0) part.face.from = shore;
    if (depth_from > 0 && depth_to < 0) part.face.to = shore;
    return part;
}

}  // namespace

void visit_tractions(const Model& model, const MidStep& mid, const JointWater& load,
                     const TractionVisit& visit) {
    for (const int edge : load.edges) {
        for (const FacePoint& point : face_points(model, mid, {edge, 0, 1}))
            visit(point, -load.pressure * point.normal);
    }
}

void visit_tractions(const Model& model, const MidStep& mid, const HeadWater& load,
                     const TractionVisit& visit) {
    for (const int edge : load.edges) {
        const Vec2& p = mid.vertices[static_cast<std::size_t>(edge)];
        const Vec2& q =
            mid.vertices[static_cast<std::size_t>(model.topology.next[static_cast<std::size_t>(edge)])];
        const auto depth = [&](double share) {
            const Vec2 at = p + share * (q - p);
            return head_at(load.head, at.x()) - at.y();
        };
        const std::vector<double> shares = pieces_of(load.head, p, q);
        for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
            const WetPart wet =
                wet_part(edge, shares[k], shares[k + 1], depth(shares[k]), depth(shares[k + 1]));
            if (wet.from <= 0 && wet.to <= 0) continue;
            for (const FacePoint& point : face_points(model, mid, wet.face)) {
                const double below = wet.from + point.share * (wet.to - wet.from);
                visit(point, -load.unit_weight * below * point.normal);
            }
        }
    }
}

}  // namespace dda
