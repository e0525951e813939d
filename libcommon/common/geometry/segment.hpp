#pragma once

#include "common/geometry/point.hpp"

namespace rockslope {

/// The distance of a point from the segment from a to b, m; from a where the segment has no length.
double distance_to_segment(const Point& p, const Point& a, const Point& b);

}  // namespace rockslope
