#pragma once

#include <string>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// The key to the colours of displacements.
struct ColourBar {
    std::string title;    ///< without its unit
    double largest = 0;   ///< m, at the dark end
    double farthest = 0;  ///< m; beyond `largest` the bar ends in a pointed tip, for more
};

/// A bar that stands right of a drawing, pale end below. @param foot its lower left corner, pt.
void draw_vertical_bar(Canvas& canvas, const ColourBar& bar, const Point& foot, double length);
/// A bar that lies below a drawing, pale end on the left. @param corner its upper left corner, pt.
void draw_horizontal_bar(Canvas& canvas, const ColourBar& bar, const Point& corner, double length);
/// pt that a bar needs right of its left edge, or below its upper one, with ticks and title.
inline constexpr double vertical_bar_width = 70, horizontal_bar_height = 46;

}  // namespace rockslope
