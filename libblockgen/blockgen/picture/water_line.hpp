#pragma once

#include <vector>

#include "common/drawing/axes.hpp"

namespace rockslope::blockgen {

/// Draws a water table within the box of the axes: a dashed blue line, level beyond its ends, with the mark
/// of a water level, a triangle that stands on its tip, near its higher side. @param line one point or more.
void draw_water_line(Canvas& canvas, const Axes& axes, const std::vector<Point>& line);

/// Draws the entry of the legend. @return the y below it.
double draw_water_legend(Canvas& canvas, const Point& upper_left);

}  // namespace rockslope::blockgen
