#pragma once

#include <compare>
#include <cstdint>

#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// Products of grid differences need more than 64 bits.
__extension__ using Int128 = __int128;

/// A point of an integer grid.
struct GridPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// Twice the signed area of the triangle a, b, c; exact for coordinates below 2^62.
inline Int128 twice_area(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

/// The side of the directed line a-b on which c lies: +1 left, -1 right, 0 on it.
inline int side_of(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    const Int128 area = twice_area(a, b, c);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// A grid with its own origin, so that coordinates far from zero keep their digits:
/// point = origin + step * grid point. Every grid point of the model is an exact double.
struct GridFrame {
    Point origin;
    double step = 0x1p-20;  ///< m, a power of two

    /// The exact coordinates of a grid point, m.
    Point position(const GridPoint& p) const {
        return {origin.x + step * static_cast<double>(p.x), origin.y + step * static_cast<double>(p.y)};
    }
};

}  // namespace rockslope::blockgen
