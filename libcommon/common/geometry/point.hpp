#pragma once

namespace rockslope {

/// A point of the section, m: x to the right, y up.
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

}  // namespace rockslope
