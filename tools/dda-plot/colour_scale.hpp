#pragma once

#include <vector>

/// A share of the section and how far it has moved.
struct MovedArea {
    double area = 0;      ///< m2
    double distance = 0;  ///< m
};

/// Of the area that counts for the colours, the part whose displacements they must tell apart. The rest, the
/// few pieces that flew far, would leave everything else pale.
inline constexpr double coloured_share = 0.99;

/// The smallest distance that at least `share` of the whole area does not exceed; 0 of no area.
double distance_covering(std::vector<MovedArea> parts, double share);

/// The next length, or the same, with which a colour bar can end: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a
/// power of ten, so that it ends on one of its own ticks. @param length positive.
double round_length_above(double length);
