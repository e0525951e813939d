#pragma once

#include <string>

#include "blockgen/picture/canvas.hpp"

/// The key to the colours of displacements.
struct ColourBar {
    std::string title;    ///< without its unit
    double largest = 0;   ///< m, at the dark end
    double farthest = 0;  ///< m; beyond `largest` the bar ends in a pointed tip, for more
};

/// A bar that stands right of a drawing, pale end below. @param foot its lower left corner, pt.
void draw_standing_bar(blockgen::Canvas& canvas, const ColourBar& bar, const blockgen::Point& foot,
                       double length);
/// A bar that lies below a drawing, pale end on the left. @param corner its upper left corner, pt.
void draw_lying_bar(blockgen::Canvas& canvas, const ColourBar& bar, const blockgen::Point& corner,
                    double length);
/// pt that a bar needs right of its left edge, or below its upper one, with ticks and title.
inline constexpr double standing_bar_width = 70, lying_bar_height = 46;
