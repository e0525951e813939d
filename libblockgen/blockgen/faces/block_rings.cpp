#include "blockgen/faces/block_rings.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace rockslope::blockgen {

namespace {

using HalfEdges = std::vector<HalfEdgeIndex>;

/// A ring that was walked: where it lies among the half-edges, its block, and its first half-edge.
struct WalkedRing {
    BlockRings::Part part;
    FaceBlockIndex block = 0;
    HalfEdgeIndex first = 0;

    /// By the first half-edges, which differ and are ordered as the vertices of the rings are.
    friend bool operator<(const WalkedRing& r, const WalkedRing& s) { return r.first < s.first; }
};

class RingCollector {
  public:
    RingCollector(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                  const BlockBoundary& boundary)
        : noded_(noded), subdivision_(subdivision), faces_(faces), boundary_(boundary) {}

    BlockRings run() {
        walk_all();
        order_outer_rings();
        order_holes();
        return std::move(rings_);
    }

  private:
    /// Each ring has a forward half-edge, that at its smallest vertex for instance.
    void walk_all() {
        std::vector<char> walked(boundary_.half_edge_count(), 0);
        seen_.assign(noded_.vertices.size(), -1);
        rings_.half_edges.reserve(boundary_.half_edge_count());
        HalfEdges walk;
        for (const EdgeIndex e : noded_.edges.indices()) {
            const HalfEdgeIndex start = forward_half(e);
            const FaceBlockIndex block = faces_.block[subdivision_.face[start]];
            if (!boundary_.is_boundary[e] || block == FaceBlocks::outside || walked[start]) continue;
            walk.clear();
            for (HalfEdgeIndex h = start; !walked[h]; h = boundary_.next(h)) {
                walked[h] = 1;
                walk.push_back(h);
            }
            split(walk, block);
        }
    }

    /// Splits a closed walk of half-edges into rings that visit each vertex once.
    void split(const HalfEdges& walk, FaceBlockIndex block) {
        open_.clear();
        for (const HalfEdgeIndex h : walk) {
            const NodeIndex vertex = boundary_.origin(h);
            if (const std::int32_t start = seen_[vertex]; start >= 0) {
                add_ring(start, block);
                for (std::size_t k = start; k < open_.size(); ++k) seen_[boundary_.origin(open_[k])] = -1;
                open_.resize(start);
            }
            seen_[vertex] = static_cast<std::int32_t>(open_.size());
            open_.push_back(h);
        }
        for (const HalfEdgeIndex h : open_) seen_[boundary_.origin(h)] = -1;
        add_ring(0, block);
    }

    /// Adds the open part of the walk from a position on, turned so that it starts at its smallest vertex. A
    /// ring is convex there, so the turn tells an outer ring from a hole.
    void add_ring(std::size_t start, FaceBlockIndex block) {
        const auto begin = open_.begin() + static_cast<std::ptrdiff_t>(start);
        const auto smallest = std::min_element(begin, open_.end(), [&](HalfEdgeIndex g, HalfEdgeIndex h) {
            return boundary_.origin(g) < boundary_.origin(h);
        });
        const HalfEdgeIndex before = smallest == begin ? open_.back() : *(smallest - 1);
        const auto corner = [&](HalfEdgeIndex h) { return noded_.vertices[boundary_.origin(h)]; };
        const bool is_outer = side_of(corner(before), corner(*smallest), corner(twin(*smallest))) > 0;
        HalfEdges& all = rings_.half_edges;
        (is_outer ? outer_ : holes_)
            .push_back(
                {{static_cast<std::int32_t>(all.size()), static_cast<std::int32_t>(open_.end() - begin)},
                 block,
                 *smallest});
        all.insert(all.end(), smallest, open_.end());
        all.insert(all.end(), begin, smallest);
    }

    void order_outer_rings() {
        if (!std::is_sorted(outer_.begin(), outer_.end())) std::sort(outer_.begin(), outer_.end());
        outer_rings_.assign(faces_.material.size(), 0);
        rings_.block.reserve(outer_.size());
        for (const WalkedRing& ring : outer_) {
            ++outer_rings_[ring.block];
            rings_.block.push_back(ring.block);
        }
        for (const FaceBlockIndex b : outer_rings_.indices())
            if (outer_rings_[b] != 1)
                throw std::logic_error("block " + std::to_string(b.value()) + " has " +
                                       std::to_string(outer_rings_[b]) + " outer rings, expected 1");
    }

    void order_holes() {
        std::sort(holes_.begin(), holes_.end());
        PerFaceBlock<std::vector<BlockRings::Part>> holes_of;
        if (!holes_.empty()) holes_of.resize(faces_.material.size());
        for (const WalkedRing& hole : holes_) holes_of[hole.block].push_back(hole.part);
        rings_.first_ring.reserve(outer_.size() + 1);
        rings_.parts.reserve(outer_.size() + holes_.size());
        for (const WalkedRing& ring : outer_) {
            rings_.parts.push_back(ring.part);
            if (!holes_.empty())
                rings_.parts.insert(rings_.parts.end(), holes_of[ring.block].begin(),
                                    holes_of[ring.block].end());
            rings_.first_ring.push_back(rings_.parts.size());
        }
    }

    const NodedEdges& noded_;
    const Subdivision& subdivision_;
    const FaceBlocks& faces_;
    const BlockBoundary& boundary_;
    /// The position of each vertex in the open part of the walk; -1 for the other vertices, before and after
    /// a walk.
    PerNode<std::int32_t> seen_;
    HalfEdges open_;  ///< the part of the walk that is in no ring yet
    std::vector<WalkedRing> outer_, holes_;
    PerFaceBlock<int> outer_rings_;  ///< number of outer rings of each block
    BlockRings rings_;
};

}  // namespace

BlockBoundary::BlockBoundary(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                             const ThreadPool& pool)
    : is_boundary(noded.edges.size()), noded_(noded), subdivision_(subdivision) {
    const auto block = [&](HalfEdgeIndex h) { return faces.block[subdivision.face[h]]; };
    pool.parallel_for(noded.edges.size(), [&](std::size_t begin, std::size_t end) {
        for (const EdgeIndex e : indices<EdgeIndex>(begin, end))
            is_boundary[e] = block(forward_half(e)) != block(backward_half(e));
    });
}

BlockRings block_rings(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                       const BlockBoundary& boundary) {
    return RingCollector(noded, subdivision, faces, boundary).run();
}

}  // namespace rockslope::blockgen
