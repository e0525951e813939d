#pragma once

#include <string>
#include <vector>

#include "common/drawing/canvas.hpp"

namespace rockslope {

/// A line of text that is at most as wide as the room, units of the drawing: its end is cut off, and an
/// ellipsis stands in its place. @param room not negative.
std::string shortened(const Canvas& canvas, const std::string& line, const TextStyle& style, double room);

/// The places of the labels of a drawing, which must not lie over each other.
class Labels {
  public:
    /// @param upper_left, lower_right box that all labels stay inside, units.
    Labels(const Point& upper_left, const Point& lower_right)
        : upper_left_(upper_left), lower_right_(lower_right) {}

    /// Keeps labels off a part of the page.
    void reserve(const Point& upper_left, const Point& lower_right) {
        taken_.push_back({upper_left.x, lower_right.x, upper_left.y, lower_right.y});
    }
    /// Writes a label, if it is inside the box and free of all earlier labels. @return whether it is written.
    bool try_at(Canvas& canvas, const Point& place, const std::string& line, const TextStyle& style);
    /// Writes a label at the first of some places where it fits; else at the first one, moved into the box.
    void put(Canvas& canvas, const std::vector<std::pair<Point, Anchor>>& places, const std::string& line,
             TextStyle style);

  private:
    struct Box {
        double left, right, top, bottom;
    };
    static Box box_of(const Canvas& canvas, const Point& place, const std::string& line,
                      const TextStyle& style);
    bool is_free(const Box& box) const;

    Point upper_left_, lower_right_;
    std::vector<Box> taken_;
};

}  // namespace rockslope
