#include <algorithm>

#include "blockgen/arrangement/arrange.hpp"
#include "blockgen/noding/bucket_grid.hpp"
#include "common/base/disjoint_sets.hpp"

namespace rockslope::blockgen {

namespace {

/// A closed walk of half-edges along one face.
using CycleIndex = Index<struct CycleKind>;

/// 0 for directions in [0, 180) degrees, 1 for the others.
int half_plane(const GridPoint& d) {
    return d.y > 0 || (d.y == 0 && d.x > 0) ? 0 : 1;
}

class FaceTracer {
  public:
    explicit FaceTracer(const NodedEdges& noded) : noded_(noded), components_(noded.vertices.size()) {
        for (const auto& [a, b] : noded.edges) components_.unite(a, b);
    }

    Subdivision run() {
        link_half_edges();
        trace_cycles();
        nest_components();
        result_.face.reserve(cycle_of_.size());
        for (const CycleIndex cycle : cycle_of_) result_.face.push_back(face_of_cycle_[cycle]);
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
    bool comes_before(HalfEdgeIndex g, HalfEdgeIndex h) const {
        const GridPoint d = direction(g), e = direction(h);
        if (half_plane(d) != half_plane(e)) return half_plane(d) < half_plane(e);
        return static_cast<Int128>(d.x) * e.y - static_cast<Int128>(d.y) * e.x > 0;
    }

    /// Along the face on its left, the next half-edge is the one clockwise after the twin, around the vertex
    /// at which the half-edge ends.
    void link_half_edges() {
        const std::size_t n = 2 * noded_.edges.size();
        PerNode<std::int32_t> first(noded_.vertices.size() + 1, 0);
        std::vector<HalfEdgeIndex> around(n);
        result_.next.resize(n);
        for (const HalfEdgeIndex h : result_.next.indices()) ++first[origin(h) + 1];
        for (const NodeIndex v : noded_.vertices.indices()) first[v + 1] += first[v];
        PerNode<std::int32_t> fill(first.begin(), first.end() - 1);
        for (const HalfEdgeIndex h : result_.next.indices()) around[fill[origin(h)]++] = h;
        for (const NodeIndex v : noded_.vertices.indices()) {
            const auto begin = around.begin() + first[v], end = around.begin() + first[v + 1];
            std::sort(begin, end, [this](HalfEdgeIndex g, HalfEdgeIndex h) { return comes_before(g, h); });
            for (auto h = begin; h != end; ++h) result_.next[twin(*h)] = h == begin ? *(end - 1) : *(h - 1);
        }
    }

    /// Numbers the cycles of half-edges. A counter-clockwise cycle bounds a new face. A clockwise cycle, or
    /// one of zero area, is the outer boundary of a connected component.
    void trace_cycles() {
        cycle_of_.assign(result_.next.size(), CycleIndex::none());
        outer_cycle_.assign(noded_.vertices.size(), CycleIndex::none());
        face_of_cycle_.clear();
        result_.face_count = 1;
        for (const HalfEdgeIndex start : result_.next.indices()) {
            if (cycle_of_[start].exists()) continue;
            const CycleIndex cycle = face_of_cycle_.size();
            Int128 twice = 0;
            const GridPoint& o = grid_point(origin(start));
            for (HalfEdgeIndex h = start; !cycle_of_[h].exists(); h = result_.next[h]) {
                cycle_of_[h] = cycle;
                twice += twice_area(o, grid_point(origin(h)), grid_point(origin(twin(h))));
            }
            face_of_cycle_.push_back(twice > 0 ? result_.face_count++ : -1);
            if (twice <= 0) outer_cycle_[components_.root(origin(start))] = cycle;
        }
    }

    /// Finds the face that contains each connected component, in the order of the leftmost vertices. The
    /// component below such a vertex has a vertex further left, or lower, so that its face is already found.
    void nest_components() {
        PerEdge<FineSegment> lines;
        lines.reserve(noded_.edges.size());
        for (const auto& [a, b] : noded_.edges) lines.push_back({grid_point(a), grid_point(b)});
        const BucketGrid grid(std::span<const FineSegment>(lines), 1);
        for (const NodeIndex v : outer_cycle_.indices()) {
            if (!outer_cycle_[v].exists()) continue;  // v is not the smallest, so leftmost, of its component
            const EdgeIndex below = edge_below(v, lines, grid);
            face_of_cycle_[outer_cycle_[v]] =
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
    DisjointSets components_;
    Subdivision result_;
    PerHalfEdge<CycleIndex> cycle_of_;
    PerNode<CycleIndex> outer_cycle_;  ///< of the component with that smallest vertex; none at other vertices
    IndexedVector<CycleIndex, FaceIndex> face_of_cycle_;  ///< none until found
};

}  // namespace

Subdivision walk_faces(const NodedEdges& noded) {
    return FaceTracer(noded).run();
}

}  // namespace rockslope::blockgen
