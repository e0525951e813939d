#pragma once

#include <span>

#include "blockgen/input/meet_section.hpp"

namespace rockslope::blockgen {

/// The angle between a joint plane and the straight line from the first point of its mapped trace to the
/// last, rad, in [0, pi/2]: zero where the trace lies in the plane. On level ground it is
/// asin(sin dip |sin b|) for a trace at the angle b to the strike. Zero for a trace that ends where it
/// begins.
/// @param elevations of the points, m; none: the ground is taken as level.
double angle_out_of_plane(std::span<const Point> trace, std::span<const double> elevations,
                          const JointPlane& plane);

}  // namespace rockslope::blockgen
