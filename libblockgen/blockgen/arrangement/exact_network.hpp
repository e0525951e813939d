#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// The arrangement of segments as they were before noding. Vertices are the ends and crossings.
struct ExactNetwork {
    std::vector<Point> vertices;  ///< grid cells from the frame's origin, to the last digit of a double
    /// Numbers of the segments through each vertex, ascending.
    std::vector<std::vector<std::int32_t>> segments_at;
    /// The cycles of vertices round each face, with the face on the left; the first face is the unbounded
    /// one.
    std::vector<std::vector<std::vector<std::int32_t>>> faces;
};

/// Arranges segments by exact predicates and exact construction (CGAL). Segments without length are left out.
/// Takes about 15 microseconds and 2 kB for each crossing.
ExactNetwork arrange_segments(std::span<const SourceSegment> segments, const GridFrame& frame);

}  // namespace rockslope::blockgen
