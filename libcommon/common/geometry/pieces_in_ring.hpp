#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/point.hpp"

namespace rockslope {

/// The pieces of the segment from a to b inside a ring, in order along it.
/// @param for_each_edge calls its argument with the ends of each edge that the segment may cross.
/// @param side whether a point lies inside (+1), on (0) or outside (-1) the ring.
template <class ForEachEdge, class Side>
std::vector<std::pair<Point, Point>> pieces_in_ring(const Point& a, const Point& b,
                                                    const ForEachEdge& for_each_edge, const Side& side) {
    const double ux = b.x - a.x, uy = b.y - a.y;
    std::vector<double> cuts = {0, 1};
    for_each_edge([&](const Point& p, const Point& q) {
        const double vx = q.x - p.x, vy = q.y - p.y, denominator = ux * vy - uy * vx;
        if (denominator == 0) return;
        const double t = ((p.x - a.x) * vy - (p.y - a.y) * vx) / denominator;
        const double s = ((p.x - a.x) * uy - (p.y - a.y) * ux) / denominator;
        if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
    });
    std::sort(cuts.begin(), cuts.end());
    const auto at = [&](double t) { return Point{a.x + t * ux, a.y + t * uy}; };
    std::vector<std::pair<Point, Point>> pieces;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        if (!(cuts[k] < cuts[k + 1]) || side(at((cuts[k] + cuts[k + 1]) / 2)) < 0) continue;
        const bool continues = !pieces.empty() && pieces.back().second == at(cuts[k]);
        if (continues)
            pieces.back().second = at(cuts[k + 1]);
        else
            pieces.emplace_back(at(cuts[k]), at(cuts[k + 1]));
    }
    return pieces;
}

}  // namespace rockslope
