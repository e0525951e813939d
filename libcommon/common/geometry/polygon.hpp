#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/point.hpp"

namespace rockslope {

/// A closed polyline; the last vertex is joined to the first and not repeated.
using Ring = std::vector<Point>;

/// Twice the signed area, m2, positive when counter-clockwise. Coordinates are taken relative to the first
/// vertex, so that large ones do not cost digits.
double twice_signed_area(std::span<const Point> ring);

/// The centroid of the area of a ring; its first point where it has no area. @param ring at least one point.
Point centroid(std::span<const Point> ring);

/// Whether a point lies inside (+1), on (0) or outside (-1) a ring, by the even-odd rule. Exact.
int side_of_ring(std::span<const Point> ring, const Point& point);

/// Two edges of a set of rings that meet where they must not. Edge k of a ring joins its vertices k and k +
/// 1.
struct RingFault {
    std::size_t first_ring = 0, first_edge = 0;
    std::size_t second_ring = 0, second_edge = 0;
    Point place;  ///< a point where the two edges meet
};

/// The first two edges that meet where they must not, or an edge of length zero. A ring may not touch itself;
/// two rings may share single vertices and touch, but neither cross nor overlap. Sweeps over x, about n log n
/// for usual rings.
std::optional<RingFault> find_ring_fault(std::span<const Ring> rings);

}  // namespace rockslope
