#include "blockgen/faces/block_rings.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rockslope::blockgen {

namespace {

using HalfEdges = std::vector<HalfEdgeIndex>;

/// Splits a closed walk of half-edges into rings that visit each vertex once. @param seen the position
/// of each vertex in the open part of the walk; -1 for the other vertices, before and after the call.
void split_walk(const HalfEdges& walk, const PerHalfEdge<NodeIndex>& origin, PerNode<std::int32_t>& seen,
                std::vector<HalfEdges>& rings) {
    HalfEdges open;
    for (const HalfEdgeIndex h : walk) {
        const NodeIndex vertex = origin[h];
        if (seen[vertex] >= 0) {
            const auto start = open.begin() + seen[vertex];
            rings.emplace_back(start, open.end());
            for (auto it = start; it != open.end(); ++it) seen[origin[*it]] = -1;
            open.erase(start, open.end());
        }
        seen[vertex] = open.size();
        open.push_back(h);
    }
    for (const HalfEdgeIndex h : open) seen[origin[h]] = -1;
    rings.push_back(std::move(open));
}

class RingCollector {
  public:
    RingCollector(const NodedEdges& noded, const BlockBoundary& boundary)
        : noded_(noded), boundary_(boundary) {}

    bool is_outer(const HalfEdges& ring) const {
        Int128 area = 0;
        const GridPoint& o = grid_point(ring[0]);
        for (std::size_t k = 1; k + 1 < ring.size(); ++k)
            area += twice_area(o, grid_point(ring[k]), grid_point(ring[k + 1]));
        return area > 0;
    }

    void rotate_to_smallest_vertex(HalfEdges& ring) const {
        const auto smaller = [this](HalfEdgeIndex g, HalfEdgeIndex h) { return vertex(g) < vertex(h); };
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), smaller), ring.end());
    }

    bool comes_before(const HalfEdges& r, const HalfEdges& s) const {
        return std::lexicographical_compare(
            r.begin(), r.end(), s.begin(), s.end(),
            [this](HalfEdgeIndex g, HalfEdgeIndex h) { return vertex(g) < vertex(h); });
    }

  private:
    NodeIndex vertex(HalfEdgeIndex h) const { return boundary_.origin[h]; }
    const GridPoint& grid_point(HalfEdgeIndex h) const { return noded_.vertices[vertex(h)]; }

    const NodedEdges& noded_;
    const BlockBoundary& boundary_;
};

}  // namespace

BlockBoundary::BlockBoundary(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces)
    : is_boundary(noded.edges.size()), origin(2 * noded.edges.size()), next(subdivision.next) {
    const auto block = [&](HalfEdgeIndex h) { return faces.block[subdivision.face[h]]; };
    for (const EdgeIndex e : noded.edges.indices()) {
        is_boundary[e] = block(forward_half(e)) != block(backward_half(e));
        origin[forward_half(e)] = noded.edges[e].first;
        origin[backward_half(e)] = noded.edges[e].second;
    }
    for (const HalfEdgeIndex h : next.indices()) {
        if (!is_boundary[edge_of(h)]) continue;
        while (!is_boundary[edge_of(next[h])]) next[h] = subdivision.next[twin(next[h])];
    }
}

std::vector<BlockRings> block_rings(const NodedEdges& noded, const Subdivision& subdivision,
                                    const FaceBlocks& faces, const BlockBoundary& boundary) {
    std::vector<BlockRings> blocks(faces.material.size());
    PerHalfEdge<char> walked(boundary.next.size(), 0);
    PerNode<std::int32_t> seen(noded.vertices.size(), -1);
    for (const HalfEdgeIndex h : boundary.next.indices()) {
        const FaceBlockIndex block = faces.block[subdivision.face[h]];
        if (!boundary.is_boundary[edge_of(h)] || block == FaceBlocks::outside || walked[h]) continue;
        HalfEdges walk;
        for (HalfEdgeIndex k = h; !walked[k]; k = boundary.next[k]) {
            walked[k] = 1;
            walk.push_back(k);
        }
        split_walk(walk, boundary.origin, seen, blocks[block].rings);
    }
    const RingCollector collector(noded, boundary);
    for (const FaceBlockIndex b : faces.material.indices()) {
        auto& rings = blocks[b].rings;
        blocks[b].block = b;
        for (HalfEdges& ring : rings) collector.rotate_to_smallest_vertex(ring);
        const auto holes = std::partition(rings.begin(), rings.end(),
                                          [&](const HalfEdges& r) { return collector.is_outer(r); });
        if (holes - rings.begin() != 1)
            throw std::logic_error("block " + std::to_string(b.value()) + " has " +
                                   std::to_string(holes - rings.begin()) + " outer rings, expected 1");
        std::sort(holes, rings.end(),
                  [&](const HalfEdges& r, const HalfEdges& s) { return collector.comes_before(r, s); });
    }
    std::sort(blocks.begin(), blocks.end(), [&](const BlockRings& a, const BlockRings& b) {
        return collector.comes_before(a.rings[0], b.rings[0]);
    });
    return blocks;
}

}  // namespace rockslope::blockgen
