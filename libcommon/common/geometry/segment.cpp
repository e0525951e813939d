#include "common/geometry/segment.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope {

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const double ux = b.x - a.x, uy = b.y - a.y, squared = ux * ux + uy * uy;
    if (squared == 0) return std::hypot(p.x - a.x, p.y - a.y);
    const double t = std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / squared, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * ux, p.y - a.y - t * uy);
}

}  // namespace rockslope
