#pragma once

#include <vector>

namespace rockslope {

/// A share of the section and how far it has moved.
struct DisplacedArea {
    double area = 0;      ///< m2
    double distance = 0;  ///< m
};

/// Of the area that counts for the colours, the part whose displacements they must tell apart. The rest, the
/// few pieces that flew far, would leave everything else pale.
inline constexpr double coloured_fraction = 0.99;

/// The smallest distance that at least `share` of the whole area does not exceed; 0 of no area.
double area_weighted_quantile(std::vector<DisplacedArea> parts, double share);

/// The next length, or the same, with which a colour bar can end: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a
/// power of ten, so that it ends on one of its own ticks. @param length positive.
double round_length_above(double length);

}  // namespace rockslope
