#pragma once

#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// The line on the map along which the section is cut. The section is the vertical plane through it; its x
/// axis runs from `from`, x = 0, to `to`, and its y axis up. m.
struct SectionLine {
    Point from, to;

    /// m
    double length() const;
    /// The direction from `from` to `to`, rad, clockwise from the map's y axis (grid north), in [0, 2 pi).
    double azimuth() const;
    /// The point of the map at an x of the section.
    Point at(double x) const;
    /// The x in the section of a point's foot on the line.
    double along(const Point& p) const;
    /// The distance of a point from the line, m, positive to its left.
    double across(const Point& p) const;
};

/// Where the section lies.
struct Section {
    double azimuth = 0;   ///< of its x axis, rad, clockwise from north
    bool on_map = false;  ///< whether `line` is known
    SectionLine line;
};

}  // namespace rockslope::blockgen
