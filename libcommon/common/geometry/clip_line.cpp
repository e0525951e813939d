#include "common/geometry/clip_line.hpp"

#include <algorithm>
#include <limits>

#include "common/geometry/pieces_in_ring.hpp"

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
    return pieces_in_ring(
        a, b,
        [&](const auto& visit) {
            for (std::size_t k = 0; k < ring.size(); ++k) visit(ring[k], ring[(k + 1) % ring.size()]);
        },
        [&](const Point& p) { return side_of_ring(ring, p); });
}

}  // namespace rockslope
