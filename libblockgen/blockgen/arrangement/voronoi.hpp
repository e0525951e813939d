#pragma once

#include <utility>
#include <vector>

#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// The edges of the Voronoi diagram of points, clipped to a box. Before that, each point is moved to the
/// centroid of its cell `relaxation` times (Lloyd 1982); points with unbounded cells do not move.
std::vector<std::pair<Point, Point>> voronoi_edges(std::vector<Point> points, int relaxation,
                                                   const Bounds& box);

}  // namespace rockslope::blockgen
