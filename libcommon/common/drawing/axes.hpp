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

/// The round values, 1, 2 or 5 times a power of ten apart, that lie in a range; at most `most` of them.
std::vector<double> round_ticks(const Range& range, int most);

/// A tick's value with no more digits than its step needs.
std::string tick_text(double value, double step);

/// How the values along an axis are written: in full where that is short, otherwise less a round offset that
/// they share, so that coordinates far from the origin stay readable and distinct.
struct TickLabels {
    std::vector<double> values;
    std::vector<std::string> texts;  ///< one for each value, less the offset
    double offset = 0;

    /// "x (m)", or with an offset "x − 6690000 (m)".
    std::string title(const std::string& quantity) const;
};

/// Labels for the round ticks of a range. Offsets are multiples of a power of ten that is at least the range.
TickLabels tick_labels(const Range& range, int most);

/// A box on the page with a linear scale on each side.
class Axes {
  public:
    /// @param upper_left, lower_right corners of the box, pt.
    Axes(Point upper_left, Point lower_right, Range x, Range y);
    /// Axes of one scale in both directions, the model as large as the given box allows and centred in it.
    static Axes of_equal_scale(Point upper_left, Point lower_right, Range x, Range y);

    Point to_page(const Point& p) const;
    Ring to_page(const Ring& ring) const;
    /// Points of the page for one unit of x.
    double scale() const { return (lower_right_.x - upper_left_.x) / (x_.high - x_.low); }
    const Point& upper_left() const { return upper_left_; }
    const Point& lower_right() const { return lower_right_; }

    /// The frame with ticks, their values and the two titles; optional grid lines.
    void draw(Canvas& canvas, const std::string& x_title, const std::string& y_title,
              bool grid = false) const;

  private:
    Point upper_left_, lower_right_;
    Range x_, y_;
};

/// A bar of a round length, about a fifth of the axes' width, at a place of the page (its left end).
void draw_scale_bar(Canvas& canvas, const Point& place, double points_per_metre, double longest_points);

/// One line of a legend: a filled box, or a line, and its text.
struct LegendEntry {
    std::string text;
    std::optional<Colour> fill = std::nullopt;
    std::optional<Stroke> stroke = std::nullopt;
    bool is_line = false;
    bool is_hatched = false;
};

/// A column of entries under a title; returns the y below it, pt.
double draw_legend(Canvas& canvas, const Point& upper_left, const std::string& title,
                   const std::vector<LegendEntry>& entries);

}  // namespace rockslope
