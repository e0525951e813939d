#pragma once

#include <optional>
#include <span>
#include <vector>

#include "blockgen/mesh/polygon.hpp"
#include "blockgen/node_joints.hpp"

namespace blockgen {

/// What lines enclose, with corners on the grid.
struct EnclosedArea {
    std::vector<Ring> outlines;  ///< counter-clockwise, of parts that share no edge; from left to right
    std::vector<std::optional<Ring>> faces;  ///< round each asked-for point, the innermost; nothing outside
};

/// The area that lines enclose together, gaps within it included, and the faces that hold the given points.
EnclosedArea enclosed_area(std::span<const SourceSegment> lines, std::span<const Point> points, double step);

}  // namespace blockgen
