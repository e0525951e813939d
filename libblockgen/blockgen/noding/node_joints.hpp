#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "blockgen/noding/grid.hpp"
#include "blockgen/noding/indices.hpp"
#include "common/base/thread_pool.hpp"

namespace rockslope::blockgen {

/// A straight piece of a joint or of an outline. `source` is that joint or outline.
struct SourceSegment {
    Point a, b;
    SourceIndex source = 0;
};

/// A source that runs along a noded edge, from the edge's first vertex to its second, or reversed. A source
/// that runs along an edge twice has two entries.
struct EdgeSource {
    SourceIndex source = 0;
    bool reversed = false;
    friend auto operator<=>(const EdgeSource&, const EdgeSource&) = default;
};

/// The two ends of an edge.
using EdgeEnds = std::pair<NodeIndex, NodeIndex>;

/// Edges between grid points that meet only at common vertices. No two edges cross or overlap, and no vertex
/// lies on, or within half a cell of, an edge that does not end there.
struct NodedEdges {
    GridFrame frame;
    PerNode<GridPoint> vertices;  ///< sorted, distinct
    PerEdge<EdgeEnds> edges;      ///< first < second; sorted, distinct
    /// Edge e has the sources [first_source[e], first_source[e + 1]).
    PerEdge<std::int32_t> first_source = {0};
    std::vector<EdgeSource> sources;
    int rounds = 0;           ///< rounds of snap rounding until nothing changed
    double largest_snap = 0;  ///< m, upper bound of the displacement of any point of a segment

    std::span<const EdgeSource> sources_of(EdgeIndex edge) const;
};

/// Cuts segments at their crossings, ends and overlaps, on a grid of the given step, by iterated snap
/// rounding with hot pixels (Hobby 1999; Halperin and Packer 2002). An edge that passes through the hot pixel
/// of a vertex is bent to that vertex; rounds repeat until no edge does. The first round takes segment ends
/// on a finer grid and merges crossings in adjacent cells into one vertex, so that joints meant to meet in
/// one point do so. The result does not depend on the order or direction of the segments, nor on the number
/// of threads. All predicates are exact. @param step m, a power of two. @throws std::invalid_argument when
/// the extent of the segments exceeds 2^38 steps, or a coordinate exceeds 2^52 steps.
NodedEdges node_joints(std::span<const SourceSegment> segments, double step,
                       const ThreadPool& pool = ThreadPool());

/// The edges that violate the invariant of NodedEdges: they cross another edge, or pass through the hot pixel
/// of a vertex that is not their end.
/// @param changed flag per edge; unchanged edges satisfy the invariant among themselves. Empty: all edges may
/// have changed. @return ascending; empty when the edges are properly noded.
std::vector<EdgeIndex> improperly_noded_edges(NodeSpan<const GridPoint> vertices,
                                              EdgeSpan<const EdgeEnds> edges,
                                              EdgeSpan<const char> changed = {},
                                              const ThreadPool& pool = ThreadPool());

}  // namespace rockslope::blockgen
