#pragma once

#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// A block as rings of half-edges: the outer ring first, then the holes. The block lies on the left.
struct BlockRings {
    FaceBlockIndex block = 0;
    std::vector<std::vector<HalfEdgeIndex>> rings;
};

/// The half-edges between two blocks, or between a block and the outside, and their order along the blocks.
/// Edges with the same block on both sides (dangling edges of joints that end in rock, bridges) are skipped.
struct BlockBoundary {
    PerEdge<char> is_boundary;
    PerHalfEdge<NodeIndex> origin;    ///< the first vertex of the half-edge
    PerHalfEdge<HalfEdgeIndex> next;  ///< valid for boundary edges only

    BlockBoundary(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces);
};

/// The rings of all blocks. A ring that returns to a vertex is split there. Each ring starts at its smallest
/// vertex; blocks are sorted by the vertices of their outer rings. @throws std::logic_error unless each block
/// has exactly one outer ring.
std::vector<BlockRings> block_rings(const NodedEdges& noded, const Subdivision& subdivision,
                                    const FaceBlocks& faces, const BlockBoundary& boundary);

}  // namespace rockslope::blockgen
