#pragma once

#include <string>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// Colour bar of displacements.
struct ColourBar {
    std::string title;    ///< without its unit
    double largest = 0;   ///< m, displacement at the dark end
    double farthest = 0;  ///< m, largest displacement; above `largest` the bar ends in a pointed tip
};

/// Draws a vertical bar right of a drawing, pale end below. @param foot its lower left corner, pt.
void draw_vertical_bar(Canvas& canvas, const ColourBar& bar, const Point& foot, double length);
/// Draws a horizontal bar below a drawing, pale end on the left. @param corner its upper left corner, pt.
void draw_horizontal_bar(Canvas& canvas, const ColourBar& bar, const Point& corner, double length);
/// Width of a vertical bar, and height of a horizontal bar, with ticks and title, pt.
inline constexpr double vertical_bar_width = 70, horizontal_bar_height = 46;

}  // namespace rockslope
