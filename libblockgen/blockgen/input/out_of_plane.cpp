#include "blockgen/input/out_of_plane.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::blockgen {

double angle_out_of_plane(std::span<const Point> trace, std::span<const double> elevations,
                          const JointPlane& plane) {
    const double east = trace.back().x - trace.front().x, north = trace.back().y - trace.front().y,
                 rise = elevations.empty() ? 0 : elevations.back() - elevations.front();
    const double length = std::hypot(east, north, rise);
    if (!(length > 0)) return 0;
    // The upward normal leans towards the dip direction.
    const double along_normal =
        std::sin(plane.dip) * (east * std::sin(plane.dip_direction) + north * std::cos(plane.dip_direction)) +
        std::cos(plane.dip) * rise;
    return std::asin(std::min(std::abs(along_normal) / length, 1.0));
}

}  // namespace rockslope::blockgen
