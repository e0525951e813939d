#pragma once

#include <vector>

namespace rockslope {

/// A part of the section and its displacement.
struct DisplacedArea {
    double area = 0;      ///< m2
    double distance = 0;  ///< m
};

/// Fraction of the area whose displacements the colour scale covers. A scale for the remaining 1 %, a few
/// pieces that moved far, would leave all others pale.
inline constexpr double coloured_fraction = 0.99;

/// Area-weighted quantile: the smallest distance that at least `fraction` of the total area does not exceed;
/// 0 for an empty list.
double area_weighted_quantile(std::vector<DisplacedArea> parts, double fraction);

/// The smallest round length not below `length`: 1, 1.5, 2, 2.5, 3, 4, 5, 6 or 8 times a power of ten. A
/// colour bar that ends there ends on a tick. @param length positive, m.
double round_length_above(double length);

}  // namespace rockslope
