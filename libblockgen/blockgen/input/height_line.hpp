#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A line that has one height at each x, m: two points or more, straight between them, whose x never
/// decreases and grows from the first to the last. Two points of one x make a step.
using HeightLine = std::vector<Point>;

/// The first point of a line that lies left of the one before it; nothing where x never decreases.
std::optional<Point> first_turn_back(const std::vector<Point>& points);

/// The line through points whose x never decreases, one or more, from x = `left` to x = `right`: level beyond
/// its ends, clipped where it is longer.
HeightLine height_line(const std::vector<Point>& points, double left, double right);

/// The lower of two lines over the same x at each x, with a point where they cross.
HeightLine lower_of(const HeightLine& a, const HeightLine& b);
/// The higher one, in the same way.
HeightLine upper_of(const HeightLine& a, const HeightLine& b);
/// The line within the heights of `low` and `high`, level at these where it leaves them.
HeightLine clamped(const HeightLine& line, double low, double high);
/// The line moved up by `rise`, m.
HeightLine moved_up(HeightLine line, double rise);

/// A place of a line and its height above another one there, m.
struct Rise {
    Point at;
    double height = 0;
};

/// Where `a` lies highest above `b` for x from `left` to `right`; negative where it lies below everywhere.
Rise largest_rise(const HeightLine& a, const HeightLine& b, double left, double right);

/// The area between two lines over the same x, counter-clockwise. Where they coincide the ring has no width,
/// and runs there and back. Empty where they coincide everywhere. @param lower nowhere above `upper`.
Ring ring_between(const HeightLine& upper, const HeightLine& lower);

}  // namespace rockslope::blockgen
