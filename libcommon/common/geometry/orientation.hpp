#pragma once

#include "common/geometry/point.hpp"

namespace rockslope {

/// The side of the directed line a-b on which c lies: +1 left, -1 right, 0 exactly on it. Exact for all
/// finite doubles whose products neither overflow nor underflow. Method: a floating-point filter, then an
/// exact sum of the error-free products (Shewchuk 1997, Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates, sections 2 and 4.1).
int orientation(const Point& a, const Point& b, const Point& c);

/// How two closed segments a-b and c-d meet.
enum class SegmentRelation {
    apart,       ///< no common point
    endpoint,    ///< one common point, an end of both
    touching,    ///< one common point, an end of one of them only
    crossing,    ///< one common point, interior to both
    overlapping  ///< a common piece of positive length
};

/// Exact, like orientation(). Both segments must have positive length.
SegmentRelation segment_relation(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace rockslope
