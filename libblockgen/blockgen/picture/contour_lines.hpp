#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// Nodes of the unit circle: on `rings` circles with radii from 1 / rings to 1, each with `spokes` points
/// from x = 0, y = 1 on clockwise, and the centre. Cells are the quadrilaterals between them.
struct DiscGrid {
    std::size_t rings = 0, spokes = 0;

    /// @param ring from 0, the centre, to `rings`. @param spoke any; it counts round the circle.
    Point node(std::size_t ring, std::size_t spoke) const;
    /// Number of a node among (rings + 1) x spokes values, of which those of the centre are equal.
    std::size_t index(std::size_t ring, std::size_t spoke) const { return ring * spokes + spoke % spokes; }
};

/// The lines along which a quantity has a value, by marching squares: straight between points of the cells'
/// sides that are interpolated linearly, so with an error that falls with the square of the cells' size. A
/// line that is closed ends where it begins; others end at the circle. No point lies outside the circle.
/// @param values at the nodes, by DiscGrid::index().
std::vector<std::vector<Point>> contour_lines(const DiscGrid& grid, const std::vector<double>& values,
                                              double level);

}  // namespace rockslope::blockgen
