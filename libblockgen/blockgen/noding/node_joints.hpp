#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "blockgen/noding/grid.hpp"

namespace rockslope::blockgen {

/// A straight piece of a joint or of an outline. `source` says which; the caller numbers them.
struct SourceSegment {
    Point a, b;
    std::int32_t source = 0;
};

/// That a source runs along a noded edge, once for each time it does. Direction: from the edge's first vertex
/// to its second, or back.
struct EdgeSource {
    std::int32_t source = 0;
    bool reversed = false;
    friend auto operator<=>(const EdgeSource&, const EdgeSource&) = default;
};

/// Edges between grid points that meet at common vertices only: no two cross or overlap, and no vertex lies
/// on, or within half a cell of, an edge that does not end there.
struct NodedEdges {
    GridFrame frame;
    std::vector<GridPoint> vertices;  ///< sorted, distinct
    std::vector<std::pair<std::int32_t, std::int32_t>>
        edges;  ///< vertex indices, first < second; sorted, distinct
    std::vector<std::int32_t> first_source = {
        0};  ///< edge e has the sources [first_source[e], first_source[e + 1])
    std::vector<EdgeSource> sources;
    int rounds = 0;           ///< of snap rounding until nothing changed
    double largest_snap = 0;  ///< m, an upper bound of how far any point of a segment moved

    std::span<const EdgeSource> sources_of(std::size_t edge) const;
};

/// Cuts segments at their crossings, ends and overlaps, on a grid of the given step, by iterated snap
/// rounding with hot pixels (Hobby 1999; Halperin and Packer 2002): an edge that passes through the cell of a
/// vertex is bent to that vertex, until none does. The first round works on a finer grid than the vertices',
/// so that joints meant to meet in one point do so: crossings in adjacent cells become one vertex. The result
/// does not depend on the order or direction of the segments. All predicates are exact.
/// @param step m, a power of two. @throws std::invalid_argument when the extent of the segments exceeds 2^38
/// steps, or a coordinate 2^52.
NodedEdges node_joints(std::span<const SourceSegment> segments, double step);

/// The edges that break the promise of NodedEdges when the given vertices and edges are taken together:
/// crossed, or with a foreign vertex in reach. Empty when they keep it.
/// @param changed per edge; those that did not change are known to keep it among themselves. Empty when all
/// may have. @return indices into `edges`, ascending.
std::vector<std::size_t> improperly_noded_edges(std::span<const GridPoint> vertices,
                                                std::span<const std::pair<std::int32_t, std::int32_t>> edges,
                                                std::span<const char> changed = {});

}  // namespace rockslope::blockgen
