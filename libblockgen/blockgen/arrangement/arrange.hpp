#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/noding/node_joints.hpp"

namespace rockslope::blockgen {

/// A planar subdivision as plain data. Edge e has the half-edges 2e, from its first to its second vertex, and
/// 2e + 1, back; each has its face on the left.
struct Subdivision {
    std::vector<std::int32_t> next;  ///< per half-edge: the one that follows along its face
    std::vector<std::int32_t> face;  ///< per half-edge; face 0 is the unbounded one
    std::int32_t face_count = 0;
};

/// The arrangement of noded edges. They are interior-disjoint and their ends are exact doubles, so that
/// inexact construction does no harm: nothing is constructed. @throws std::logic_error when the edges break
/// their promise.
Subdivision arrange(const NodedEdges& noded);

/// What an arrangement with exact construction makes of the same edges, for comparison.
struct ArrangementSummary {
    std::size_t vertices = 0;
    std::size_t edges = 0;
    /// Twice the area of every bounded face without its holes, in cells, ascending.
    std::vector<Int128> twice_areas;
    /// The pairs of faces that share an edge, each face by its rank of area (ties share a rank); sorted, with
    /// repetitions.
    std::vector<std::pair<std::int32_t, std::int32_t>> adjacency;
};

/// Recuts the edges with exact arithmetic throughout, assuming nothing of them.
ArrangementSummary arrange_exactly(const NodedEdges& noded);

/// The same summary of a subdivision.
ArrangementSummary summarize(const NodedEdges& noded, const Subdivision& subdivision);

}  // namespace rockslope::blockgen
