#include "common/geometry/clip_line.hpp"

#include <algorithm>
#include <limits>

namespace rockslope {

namespace {

/// Narrows [low, high] to the t with min <= start + t slope <= max.
void clip_to_slab(double start, double slope, double min, double max, double& low, double& high) {
    if (slope == 0) {
        if (start < min || start > max) high = -std::numeric_limits<double>::infinity();
        return;
    }
    const auto [first, last] = std::minmax({(min - start) / slope, (max - start) / slope});
    low = std::max(low, first);
    high = std::min(high, last);
}

}  // namespace

Bounds Bounds::of(const Ring& ring) {
    Bounds bounds{ring.front(), ring.front()};
    for (const Point& p : ring) {
        bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y)};
        bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y)};
    }
    return bounds;
}

std::array<Point, 4> Bounds::corners() const {
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Bounds Bounds::expanded(double margin) const {
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
}

Point Bounds::nearest(const Point& p) const {
    return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
}

std::optional<std::pair<double, double>> Bounds::clip(const Point& point, const Point& direction) const {
    double first = -std::numeric_limits<double>::infinity(), last = -first;
    clip_to_slab(point.x, direction.x, low.x, high.x, first, last);
    clip_to_slab(point.y, direction.y, low.y, high.y, first, last);
    if (!(first < last)) return std::nullopt;
    return std::pair(first, last);
}

std::vector<std::pair<Point, Point>> clip_to_ring(const Point& a, const Point& b, const Ring& ring) {
    const double ux = b.x - a.x, uy = b.y - a.y;
    std::vector<double> cuts = {0, 1};
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point& p = ring[k];
        const Point& q = ring[(k + 1) % ring.size()];
        const double vx = q.x - p.x, vy = q.y - p.y, denominator = ux * vy - uy * vx;
        if (denominator == 0) continue;
        const double t = ((p.x - a.x) * vy - (p.y - a.y) * vx) / denominator;
        const double s = ((p.x - a.x) * uy - (p.y - a.y) * ux) / denominator;
        if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    const auto at = [&](double t) { return Point{a.x + t * ux, a.y + t * uy}; };
    std::vector<std::pair<Point, Point>> pieces;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        if (!(cuts[k] < cuts[k + 1]) || side_of_ring(ring, at((cuts[k] + cuts[k + 1]) / 2)) < 0) continue;
        const bool continues = !pieces.empty() && pieces.back().second == at(cuts[k]);
        if (continues)
            pieces.back().second = at(cuts[k + 1]);
        else
            pieces.emplace_back(at(cuts[k]), at(cuts[k + 1]));
    }
    return pieces;
}

}  // namespace rockslope
