#pragma once

#include <cstdint>
#include <vector>

#include "blockgen/faces/classify_faces.hpp"

namespace rockslope::blockgen {

/// A block as rings of half-edges, its rock on their left: the outer ring first, then the holes.
struct BlockRings {
    std::int32_t block = 0;  ///< as FaceBlocks numbers it
    std::vector<std::vector<std::int32_t>> rings;
};

/// The half-edges that part a block from another or from the outside, and how they follow one another. Edges
/// with the same block on both sides (joints that end in rock, bridges) are skipped over.
struct BlockBoundary {
    std::vector<char> is_boundary;     ///< per edge
    std::vector<std::int32_t> origin;  ///< per half-edge, vertex
    std::vector<std::int32_t> next;    ///< per half-edge; meaningful for kept ones

    BlockBoundary(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces);
};

/// All blocks; a ring that comes back to a vertex is split there. Order: by the smallest vertex of the outer
/// ring, where each ring starts; ties by the ring's further vertices. @throws std::logic_error unless each
/// block has exactly one outer ring.
std::vector<BlockRings> block_rings(const NodedEdges& noded, const Subdivision& subdivision,
                                    const FaceBlocks& faces, const BlockBoundary& boundary);

}  // namespace rockslope::blockgen
