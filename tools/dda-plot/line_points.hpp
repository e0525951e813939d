#pragma once

#include <vector>

#include "common/drawing/axes.hpp"

namespace rockslope {

/// A little more than an interval, so that lines keep off the frame; some width for a single value.
Range padded(double low, double high);

/// A line's points, values times `factor`: more samples than a line can show are thinned so that each
/// interval keeps its smallest and largest value in their order.
std::vector<Point> line_points(const std::vector<double>& time, const std::vector<double>& value,
                               double factor);

}  // namespace rockslope
