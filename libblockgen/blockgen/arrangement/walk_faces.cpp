#include <algorithm>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/noding/bucket_grid.hpp"
#include "common/base/disjoint_sets.hpp"

namespace rockslope::blockgen {

namespace {

/// A closed walk of half-edges along one face.
using CycleIndex = Index<struct CycleKind>;

class FaceTracer {
  public:
    FaceTracer(const NodedEdges& noded, const ThreadPool& pool)
        : noded_(noded), pool_(pool), components_(noded.vertices.size()) {
        for (const auto& [a, b] : noded.edges) components_.unite(a, b);
    }

    Subdivision run() {
        link_half_edges();
        trace_cycles();
        nest_components();
        result_.face.resize(cycle_of_.size());
        pool_.parallel_for(cycle_of_.size(), [&](std::size_t begin, std::size_t end) {
            for (const HalfEdgeIndex h : indices<HalfEdgeIndex>(begin, end))
                result_.face[h] = face_of_cycle_[cycle_of_[h]];
        });
        return std::move(result_);
    }

  private:
    NodeIndex origin(HalfEdgeIndex h) const {
        const auto& [a, b] = noded_.edges[edge_of(h)];
        return is_forward(h) ? a : b;
    }
    const GridPoint& grid_point(NodeIndex v) const { return noded_.vertices[v]; }
    GridPoint direction(HalfEdgeIndex h) const {
        const GridPoint &a = grid_point(origin(h)), &b = grid_point(origin(twin(h)));
        return {b.x - a.x, b.y - a.y};
    }
    /// Counter-clockwise from straight down: half-edges to the right, which are forward, then those to the
    /// left.
    bool comes_before(HalfEdgeIndex g, HalfEdgeIndex h) const {
        if (is_forward(g) != is_forward(h)) return is_forward(g);
        const GridPoint d = direction(g), e = direction(h);
        return static_cast<Int128>(d.x) * e.y - static_cast<Int128>(d.y) * e.x > 0;
    }

    /// Along the face on its left, the next half-edge is the one clockwise after the twin, around the vertex
    /// at which the half-edge ends.
    void link_half_edges() {
        const std::size_t n = 2 * noded_.edges.size();
        PerNode<std::int32_t> first(noded_.vertices.size() + 1, 0);
        std::vector<HalfEdgeIndex> around(n);
        result_.next.resize(n);
        for (const auto& [a, b] : noded_.edges) ++first[a + 1], ++first[b + 1];
        for (const NodeIndex v : noded_.vertices.indices()) first[v + 1] += first[v];
        PerNode<std::int32_t> fill(first.begin(), first.end() - 1);
        for (const HalfEdgeIndex h : result_.next.indices()) around[fill[origin(h)]++] = h;
        outermost_.resize(noded_.vertices.size());
        pool_.parallel_for(noded_.vertices.size(), [&](std::size_t from, std::size_t to) {
            for (const NodeIndex v : indices<NodeIndex>(from, to)) {
                const auto begin = around.begin() + first[v], end = around.begin() + first[v + 1];
                if (begin == end) continue;
                std::sort(begin, end,
                          [this](HalfEdgeIndex g, HalfEdgeIndex h) { return comes_before(g, h); });
                for (auto h = begin; h != end; ++h)
                    result_.next[twin(*h)] = h == begin ? *(end - 1) : *(h - 1);
                outermost_[v] = *(end - 1);
            }
        });
    }

    /// Numbers the cycles of half-edges. The outer boundary of a connected component is the cycle that passes
    /// its leftmost vertex on the left, so along the last half-edge around that vertex. Each other cycle
    /// is counter-clockwise and bounds a new face.
    void trace_cycles() {
        cycle_of_.assign(result_.next.size(), CycleIndex::none());
        CycleIndex cycle = 0;
        for (const HalfEdgeIndex start : result_.next.indices()) {
            if (cycle_of_[start].exists()) continue;
            for (HalfEdgeIndex h = start; !cycle_of_[h].exists(); h = result_.next[h]) cycle_of_[h] = cycle;
            ++cycle;
        }
        face_of_cycle_.assign(cycle.value(), FaceIndex(0));
        for (const NodeIndex v : noded_.vertices.indices())
            if (components_.root(v) == std::size_t{v}) {
                roots_.push_back(v);
                face_of_cycle_[outer_cycle(v)] = FaceIndex::none();
            }
        result_.face_count = 1;
        for (FaceIndex& face : face_of_cycle_)
            if (face.exists()) face = result_.face_count++;
    }

    CycleIndex outer_cycle(NodeIndex root) const { return cycle_of_[outermost_[root]]; }

    /// Finds the face that contains each connected component, in the order of the leftmost vertices. The
    /// component below such a vertex has a vertex further left, or lower, so that its face is already found.
    void nest_components() {
        if (roots_.size() == 1) {
            face_of_cycle_[outer_cycle(roots_[0])] = 0;
            return;
        }
        PerEdge<FineSegment> lines(noded_.edges.size());
        pool_.parallel_for(lines.size(), [&](std::size_t begin, std::size_t end) {
            for (const EdgeIndex e : indices<EdgeIndex>(begin, end))
                lines[e] = {grid_point(noded_.edges[e].first), grid_point(noded_.edges[e].second)};
        });
        const BucketGrid grid(std::span<const FineSegment>(lines), 1, {}, pool_);
        for (const NodeIndex v : roots_) {
            const EdgeIndex below = edge_below(v, lines, grid);
            face_of_cycle_[outer_cycle(v)] =
                below.exists() ? face_of_cycle_[cycle_of_[forward_half(below)]] : FaceIndex(0);
        }
    }

    /// The first edge of another component on the vertical ray down from v, with the ray shifted to the right
    /// by an infinitesimal; none if there is no such edge.
    EdgeIndex edge_below(NodeIndex v, const PerEdge<FineSegment>& lines, const BucketGrid& grid) {
        const GridPoint& p = noded_.vertices[v];
        EdgeIndex best = EdgeIndex::none();
        for (std::size_t bucket = grid.bucket_of(p);; --bucket) {
            for (const SegmentIndex segment : grid.segments_of(bucket)) {
                const EdgeIndex e = segment.value();
                const FineSegment& s = lines[e];
                if (!(s.a.x <= p.x && p.x < s.b.x) || side_of(s.a, s.b, p) <= 0) continue;
                if (components_.root(noded_.edges[e].first) == v) continue;
                if (!best.exists() || is_above(s, lines[best], p.x)) best = e;
            }
            // No edge in a lower bucket lies above an edge that crosses x = p.x within this bucket.
            const bool is_found = best.exists() && grid.bottom_of(bucket) <= height(lines[best], p.x);
            if (is_found || grid.row_of(bucket) == 0) break;
        }
        return best;
    }

    static double height(const FineSegment& s, std::int64_t x) {
        return static_cast<double>(s.a.y) + static_cast<double>(x - s.a.x) *
                                                static_cast<double>(s.b.y - s.a.y) /
                                                static_cast<double>(s.b.x - s.a.x);
    }

    /// Whether s lies above t just to the right of x.
    static bool is_above(const FineSegment& s, const FineSegment& t, std::int64_t x) {
        const Int128 s_dx = s.b.x - s.a.x, t_dx = t.b.x - t.a.x, s_dy = s.b.y - s.a.y, t_dy = t.b.y - t.a.y;
        const Int128 s_high = (s.a.y * s_dx + (x - s.a.x) * s_dy) * t_dx;
        const Int128 t_high = (t.a.y * t_dx + (x - t.a.x) * t_dy) * s_dx;
        return s_high != t_high ? s_high > t_high : s_dy * t_dx > t_dy * s_dx;
    }

    const NodedEdges& noded_;
    const ThreadPool& pool_;
    DisjointSets components_;
    Subdivision result_;
    PerHalfEdge<CycleIndex> cycle_of_;
    PerNode<HalfEdgeIndex> outermost_;  ///< the last half-edge around each vertex
    std::vector<NodeIndex> roots_;      ///< the leftmost vertices of the connected components, ascending
    IndexedVector<CycleIndex, FaceIndex> face_of_cycle_;  ///< none until found
};

}  // namespace

Subdivision walk_faces(const NodedEdges& noded, const ThreadPool& pool) {
    return FaceTracer(noded, pool).run();
}

}  // namespace rockslope::blockgen
