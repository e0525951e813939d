#pragma once

#include <utility>
#include <vector>

#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// The edges of the Voronoi cells of points, those that meet a box, cut to it. Before, each point moves
/// `relaxation` times to the centroid of its cell; points with unbounded cells stay.
std::vector<std::pair<Point, Point>> voronoi_edges(std::vector<Point> points, int relaxation,
                                                   const Bounds& box);

}  // namespace rockslope::blockgen
