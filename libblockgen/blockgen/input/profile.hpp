#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// What is wrong with a profile, and the number of the point at which it is.
struct ProfileFault {
    std::size_t point = 0;
    std::string what, expected;
};

/// The first fault of a profile of the ground, points of the section from left to right: fewer than two
/// points, two equal points in a row, an x smaller than the one before, or a vertical step that turns back
/// over itself. Vertical steps are allowed, overhangs are not.
std::optional<ProfileFault> find_profile_fault(std::span<const Point> profile);

/// The line without the points that are not needed to keep each of its points within `tolerance`, m, of the
/// straight piece that replaces it, measured as the distance from that piece (Douglas and Peucker 1973). Its
/// ends stay.
std::vector<Point> simplified(std::span<const Point> line, double tolerance);

/// The part of a profile between two x, with points interpolated at them. Fewer than two points when it has
/// none. @param profile without a fault.
std::vector<Point> clipped_profile(std::span<const Point> profile, double low, double high);

}  // namespace rockslope::blockgen
