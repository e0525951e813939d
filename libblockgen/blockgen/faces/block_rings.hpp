#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blockgen/faces/classify_faces.hpp"
#include "blockgen/mesh/indices.hpp"

namespace rockslope::blockgen {

/// The half-edges between two blocks, or between a block and the outside, and their order along the blocks.
/// Edges with the same block on both sides (dangling edges of joints that end in rock, bridges) are skipped.
/// References; the cutter owns the network and its subdivision.
class BlockBoundary {
  public:
    BlockBoundary(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                  const ThreadPool& pool = ThreadPool());

    PerEdge<char> is_boundary;

    /// Number of half-edges, of the boundary or not.
    std::size_t half_edge_count() const { return subdivision_.next.size(); }
    /// All half-edges, of the boundary or not.
    IndexRange<HalfEdgeIndex> half_edges() const { return subdivision_.next.indices(); }
    /// The first vertex of a half-edge.
    NodeIndex origin(HalfEdgeIndex h) const {
        const EdgeEnds& edge = noded_.edges[edge_of(h)];
        return is_forward(h) ? edge.first : edge.second;
    }
    /// The next half-edge of the boundary along the same block, after a half-edge of the boundary.
    HalfEdgeIndex next(HalfEdgeIndex h) const {
        HalfEdgeIndex after = subdivision_.next[h];
        while (!is_boundary[edge_of(after)]) after = subdivision_.next[twin(after)];
        return after;
    }

  private:
    const NodedEdges& noded_;
    const Subdivision& subdivision_;
};

/// A ring of half-edges along one block, which lies on the left.
using RingSpan = std::span<const HalfEdgeIndex>;

/// The blocks as rings of half-edges. Block b owns the rings [first_ring[b], first_ring[b + 1]): the outer
/// ring first, then the holes.
struct BlockRings {
    PerBlock<FaceBlockIndex> block;  ///< its number among the groups of faces
    PerBlock<RingIndex> first_ring = {0};

    /// Number of blocks.
    std::size_t block_count() const { return block.size(); }
    /// The indices of all blocks.
    IndexRange<BlockIndex> blocks() const { return block.indices(); }
    /// Number of rings of a block.
    std::size_t ring_count(BlockIndex b) const { return first_ring[b + 1] - first_ring[b]; }
    /// A ring of a block; ring 0 is the outer one.
    RingSpan ring(BlockIndex b, std::size_t ring) const {
        const Part& part = parts[first_ring[b] + ring];
        return std::span(half_edges).subspan(part.begin, part.size);
    }

    /// A ring's place in `half_edges`.
    struct Part {
        std::int32_t begin = 0, size = 0;
    };
    PerRing<Part> parts;
    std::vector<HalfEdgeIndex> half_edges;
};

/// The rings of all blocks. A ring that returns to a vertex is split there. Each ring starts at its smallest
/// vertex; blocks are sorted by the vertices of their outer rings. @throws std::logic_error unless each block
/// has exactly one outer ring.
BlockRings block_rings(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                       const BlockBoundary& boundary);

}  // namespace rockslope::blockgen
