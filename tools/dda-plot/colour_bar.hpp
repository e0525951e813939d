#pragma once

#include <string>

#include "common/drawing/canvas.hpp"
#include "frame_field.hpp"

namespace rockslope {

/// The colours of a field.
struct ColourRange {
    double largest = 0;      ///< SI unit, value at the dark end, positive
    double farthest = 0;     ///< SI unit, largest magnitude; above `largest` the bar ends in a pointed tip
    bool is_signed = false;  ///< the colours go both ways from zero, to -largest and largest
    double pale = 0;         ///< part of the scale left out at its pale end, for thin lines

    /// The colour of a value.
    Colour colour_of(double value) const;
};

/// Colour bar of a field.
struct ColourBar {
    std::string title;  ///< without its unit
    FieldUnit unit = FieldUnit::length;
    ColourRange range;
};

/// Draws a vertical bar right of a drawing, pale end below. @param foot its lower left corner.
void draw_vertical_bar(Canvas& canvas, const ColourBar& bar, const Point& foot, double length);
/// Draws a horizontal bar below a drawing, pale end on the left. @param corner its upper left corner.
void draw_horizontal_bar(Canvas& canvas, const ColourBar& bar, const Point& corner, double length);
/// Width of a vertical bar, and height of a horizontal bar, with ticks and title, units of the page.
inline constexpr double vertical_bar_width = 70, horizontal_bar_height = 46;

}  // namespace rockslope
