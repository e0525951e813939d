#pragma once

#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// A closed interval of a plotted quantity.
struct Range {
    double low = 0;
    double high = 1;
};

/// Tick values in a range, at most `most`. Their spacing is 1, 2 or 5 times a power of ten.
std::vector<double> round_ticks(const Range& range, int most);

/// The text of a tick, with no more digits than the tick spacing needs.
std::string tick_text(double value, double step);

/// Tick labels of an axis. Long values are written relative to a common round offset, so that coordinates far
/// from the origin stay readable and distinct.
struct TickLabels {
    std::vector<double> values;
    std::vector<std::string> texts;  ///< one for each value, offset subtracted
    double offset = 0;

    /// "x (m)", or with an offset "x − 6690000 (m)".
    std::string title(const std::string& quantity) const;
};

/// Labels of the ticks of a range. The offset is a multiple of a power of ten that is at least the range.
TickLabels tick_labels(const Range& range, int most);

/// A box on the page with a linear scale on each side.
class Axes {
  public:
    /// @param upper_left, lower_right corners of the box, units.
    Axes(Point upper_left, Point lower_right, Range x, Range y);
    /// Axes with the same scale in both directions. The ranges fill the given box in one direction and are
    /// centred in the other.
    static Axes of_equal_scale(Point upper_left, Point lower_right, Range x, Range y);

    /// Place on the page, units, of a point of the drawing.
    Point to_page(const Point& p) const;
    Ring to_page(const Ring& ring) const;
    /// Points of the page for one unit of x.
    double scale() const { return (lower_right_.x - upper_left_.x) / (x_.high - x_.low); }
    /// The upper left corner of the box on the page, units.
    const Point& upper_left() const { return upper_left_; }
    /// The lower right corner of the box on the page, units.
    const Point& lower_right() const { return lower_right_; }

    /// Draws the frame, ticks, tick labels, titles and optional grid lines.
    void draw(Canvas& canvas, const std::string& x_title, const std::string& y_title,
              bool grid = false) const;

  private:
    Point upper_left_, lower_right_;
    Range x_, y_;
};

/// Draws a scale bar of a round length. @param place its upper left corner, units.
/// @param longest_points upper bound of its length on the page, units.
void draw_scale_bar(Canvas& canvas, const Point& place, double points_per_metre, double longest_points);

/// One line of a legend: a filled box, a line or a circle, and its text.
struct LegendEntry {
    std::string text;
    std::optional<Colour> fill = std::nullopt;
    std::optional<Stroke> stroke = std::nullopt;
    bool is_line = false;
    bool is_hatched = false;
    bool is_circle = false;
};

/// Draws the mark and the text of an entry, shortened to the room that its text has, units.
void draw_legend_entry(Canvas& canvas, const Point& upper_left, const LegendEntry& entry, double text_room);

/// Draws a column of entries under a title. @param room width that all of it has, units. @return the y below
/// it, units.
double draw_legend(Canvas& canvas, const Point& upper_left, const std::string& title,
                   const std::vector<LegendEntry>& entries, double room = 1e9);

}  // namespace rockslope
