#pragma once

#include <vector>

#include "common/drawing/axes.hpp"

namespace rockslope {

/// An interval widened by 5 % on each side; a single value gets a positive width.
Range padded(double low, double high);

/// Points of a line, with the values multiplied by `factor`. A long line is thinned to about 2000 intervals,
/// each with its smallest and largest value in their order.
std::vector<Point> line_points(const std::vector<double>& time, const std::vector<double>& value,
                               double factor);

}  // namespace rockslope
