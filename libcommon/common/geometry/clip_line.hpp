#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope {

/// An axis-aligned box.
struct Bounds {
    Point low, high;

    /// The smallest box around a ring.
    static Bounds of(const Ring& ring);
    /// The four corners.
    std::array<Point, 4> corners() const;
    /// The box with a margin on each side.
    Bounds expanded(double margin) const;
    /// The point of the box nearest to p.
    Point nearest(const Point& p) const;
    /// The interval of t in which point + t direction lies in the box. Nothing if the line misses the box.
    std::optional<std::pair<double, double>> clip(const Point& point, const Point& direction) const;
};

/// The pieces of a segment inside a ring, in order along it.
std::vector<std::pair<Point, Point>> clip_to_ring(const Point& a, const Point& b, const Ring& ring);

}  // namespace rockslope
