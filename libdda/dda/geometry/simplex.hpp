#pragma once

#include <span>

#include "dda/base/indices.hpp"
#include "dda/base/types.hpp"

namespace rockslope::dda {

/// Area moments of a region, Eq. (4), the sums of Shi's simplex integrals over its rings.
struct AreaMoments {
    double area = 0;               ///< m2
    Vec2 centroid = Vec2::Zero();  ///< m
    double xx = 0;                 ///< integral of x^2 about the centroid, m4
    double yy = 0;                 ///< integral of y^2 about the centroid, m4
    double xy = 0;                 ///< integral of x y about the centroid, m4
};

/// Simplex integration over a polygon with holes, Eq. (5). Each edge spans an oriented simplex with a common
/// apex; the signed integrals over the simplices add up. The apex is the first vertex, so that a model far
/// from the origin loses no digits. Outer ring counter-clockwise, holes clockwise.
/// @param vertices the rings' vertices, ring after ring, at least 3 each; @param ring_ends ascending, one
/// more than there are rings: from each to the next is a ring, counted from the first of them.
AreaMoments integrate(std::span<const Vec2> vertices, std::span<const CornerIndex> ring_ends);

}  // namespace rockslope::dda
