#pragma once

#include <cmath>

namespace rockslope {

/// A direction in space, of unit length.
struct SpaceDirection {
    double east = 0, north = 0, down = 1;
};

/// Cosine of the angle between two directions.
inline double dot(const SpaceDirection& a, const SpaceDirection& b) {
    return a.east * b.east + a.north * b.north + a.down * b.down;
}

/// The downward normal of a plane. @param dip, dip_direction rad, clockwise from north.
inline SpaceDirection downward_pole(double dip, double dip_direction) {
    return {-std::sin(dip) * std::sin(dip_direction), -std::sin(dip) * std::cos(dip_direction),
            std::cos(dip)};
}

}  // namespace rockslope
