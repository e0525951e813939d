#pragma once

#include <vector>

#include "common/geometry/point.hpp"
#include "common/geometry/space_direction.hpp"

namespace rockslope::blockgen {

/// Lambert's azimuthal equal-area projection of the lower hemisphere (Schmidt's net) on the unit circle, x to
/// the east and y to the north: a line at the angle t to the vertical lies at sqrt(2) sin(t / 2) from the
/// centre. A line that points upwards is drawn by its lower end.
Point equal_area(const SpaceDirection& direction);

/// The downward line at a point of the unit circle: the inverse of equal_area().
SpaceDirection direction_at(const Point& p);

/// The plane's trace on the lower hemisphere, from one end of its strike line to the other, projected.
std::vector<Point> great_circle(double dip, double dip_direction);

/// The lower half of a cone of lines at an angle, rad, to the north, projected.
std::vector<Point> small_circle(double angle);

}  // namespace rockslope::blockgen
