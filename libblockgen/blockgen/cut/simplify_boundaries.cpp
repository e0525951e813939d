#include "blockgen/cut/simplify_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rockslope::blockgen {

namespace {

constexpr double max_deviation = 2;  // grid cells

/// A chain of boundary edges between two vertices that are not removable, with a removable vertex between.
struct Chain {
    std::vector<NodeIndex> vertices;
    bool is_exact = false;     ///< along the outline of the rock
    bool is_restored = false;  ///< all its vertices are kept
};
using ChainIndex = Index<struct ChainKind>;

/// The boundary edges without the vertices to be removed.
struct StraightEdges {
    PerEdge<EdgeEnds> edges;
    PerEdge<ChainIndex> chain;  ///< none for an edge that is in no chain
    PerEdge<char> changed;      ///< whether the chain has lost a vertex
};

class BoundarySimplifier {
  public:
    BoundarySimplifier(const CutContext& cut, const BlockBoundary& boundary, const PerEdge<EdgeMark>& marks)
        : noded_(cut.noded), cut_(cut), boundary_(boundary), marks_(marks) {
        find_removable_vertices();
        if (std::find(is_removable_.begin(), is_removable_.end(), 1) != is_removable_.end()) find_chains();
    }

    PerNode<char> run() {
        PerNode<char> out(noded_.vertices.size(), 0);
        while (!chains_.empty()) {
            bool any_removed = false;
            for (const Chain& chain : chains_) {
                for (std::size_t k = 1; k + 1 < chain.vertices.size(); ++k) out[chain.vertices[k]] = 1;
                const std::vector<NodeIndex> kept = kept_vertices(chain);
                for (const NodeIndex v : kept) out[v] = 0;
                any_removed = any_removed || kept.size() < chain.vertices.size();
            }
            if (!any_removed) break;
            if (!restore_improperly_noded(straight_edges(out)) && !restore_inverted_rings(out)) break;
        }
        return out;
    }

  private:
    void find_removable_vertices() {
        PerNode<int> degree(noded_.vertices.size(), 0);
        PerNode<EdgeIndex> one_edge(noded_.vertices.size(), EdgeIndex::none());
        is_removable_.assign(noded_.vertices.size(), 1);
        for (const EdgeIndex e : noded_.edges.indices()) {
            if (!boundary_.is_boundary[e]) continue;
            for (const NodeIndex v : {noded_.edges[e].first, noded_.edges[e].second}) {
                ++degree[v];
                if (one_edge[v].exists() && !(marks_[one_edge[v]] == marks_[e])) is_removable_[v] = 0;
                one_edge[v] = e;
            }
        }
        for (const NodeIndex v : is_removable_.indices())
            is_removable_[v] = is_removable_[v] && degree[v] == 2;
    }

    NodeIndex origin(HalfEdgeIndex h) const { return boundary_.origin(h); }
    HalfEdgeIndex next(HalfEdgeIndex h) const { return boundary_.next(h); }
    bool has_removable_end(EdgeIndex e) const {
        const auto& [a, b] = noded_.edges[e];
        return boundary_.is_boundary[e] && (is_removable_[a] || is_removable_[b]);
    }

    void find_chains() {
        PerEdge<char> used(noded_.edges.size(), 0);
        chain_of_.assign(noded_.edges.size(), ChainIndex::none());
        for (const HalfEdgeIndex h : boundary_.half_edges())
            if (has_removable_end(edge_of(h)) && !used[edge_of(h)] && !is_removable_[origin(h)])
                walk(h, used);
        // The remaining edges form closed rings of removable vertices, which are opened at their smallest
        // vertex.
        for (const HalfEdgeIndex h : boundary_.half_edges()) {
            if (!has_removable_end(edge_of(h)) || used[edge_of(h)]) continue;
            HalfEdgeIndex smallest = h;
            for (HalfEdgeIndex k = next(h); k != h; k = next(k))
                if (origin(k) < origin(smallest)) smallest = k;
            is_removable_[origin(smallest)] = 0;
            walk(smallest, used);
        }
    }

    void walk(HalfEdgeIndex h, PerEdge<char>& used) {
        Chain chain;
        chain.is_exact =
            cut_.block_of(h) == FaceBlocks::outside || cut_.block_of(twin(h)) == FaceBlocks::outside;
        chain.vertices.push_back(origin(h));
        for (HalfEdgeIndex k = h;; k = next(k)) {
            used[edge_of(k)] = 1;
            chain_of_[edge_of(k)] = chains_.size();
            chain.vertices.push_back(origin(twin(k)));
            if (!is_removable_[origin(twin(k))]) break;
        }
        chains_.push_back(std::move(chain));
    }

    /// @param out flag per vertex: removed.
    StraightEdges straight_edges(const PerNode<char>& out) const {
        StraightEdges straight;
        const auto add = [&](NodeIndex a, NodeIndex b, ChainIndex chain, bool changed) {
            straight.edges.push_back(std::minmax({a, b}));
            straight.chain.push_back(chain);
            straight.changed.push_back(changed);
        };
        for (const EdgeIndex e : noded_.edges.indices())
            if (boundary_.is_boundary[e] && !chain_of_[e].exists())
                add(noded_.edges[e].first, noded_.edges[e].second, ChainIndex::none(), false);
        for (const ChainIndex c : chains_.indices()) {
            const std::vector<NodeIndex>& all = chains_[c].vertices;
            const bool changed =
                std::any_of(all.begin() + 1, all.end() - 1, [&](NodeIndex v) { return out[v] != 0; });
            for (std::size_t k = 1, last = 0; k < all.size(); ++k) {
                if (k + 1 < all.size() && out[all[k]]) continue;
                add(all[last], all[k], c, changed);
                last = k;
            }
        }
        return straight;
    }

    const GridPoint& grid_point(NodeIndex v) const { return noded_.vertices[v]; }

    /// Distance of v from the line a-b, or from a when a equals b, in cells. With `exact`, a vertex off the
    /// line is at least twice max_deviation away.
    double distance(NodeIndex a, NodeIndex b, NodeIndex v, bool exact) const {
        const GridPoint &p = grid_point(a), &q = grid_point(b), &r = grid_point(v);
        const Int128 area = twice_area(p, q, r);
        if (a != b && area == 0) return 0;
        if (a == b) return std::hypot(static_cast<double>(r.x - p.x), static_cast<double>(r.y - p.y));
        const double height = std::abs(static_cast<double>(area)) /
                              std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
        return exact ? std::max(height, 2 * max_deviation) : height;
    }

    /// Line simplification by Douglas and Peucker (1973) between the chain's ends.
    std::vector<NodeIndex> kept_vertices(const Chain& chain) const {
        if (chain.is_restored) return chain.vertices;
        std::vector<char> keep(chain.vertices.size(), 0);
        keep.front() = keep.back() = 1;
        std::vector<std::pair<std::size_t, std::size_t>> open = {{0, chain.vertices.size() - 1}};
        while (!open.empty()) {
            const auto [first, last] = open.back();
            open.pop_back();
            double farthest = 0;
            std::size_t where = first;
            for (std::size_t k = first + 1; k < last; ++k) {
                const double d =
                    distance(chain.vertices[first], chain.vertices[last], chain.vertices[k], chain.is_exact);
                if (d > farthest) farthest = d, where = k;
            }
            const bool closed = chain.vertices[first] == chain.vertices[last];
            if (where == first || (farthest <= max_deviation && !closed)) continue;
            keep[where] = 1;
            open.emplace_back(first, where);
            open.emplace_back(where, last);
        }
        std::vector<NodeIndex> kept;
        for (std::size_t k = 0; k < keep.size(); ++k)
            if (keep[k]) kept.push_back(chain.vertices[k]);
        return kept;
    }

    /// Restores the vertices of chains that now share an edge, cross another chain or pass too near a vertex.
    /// @return whether a chain was restored.
    bool restore_improperly_noded(const StraightEdges& straight) {
        bool any = false;
        const auto restore = [&](EdgeIndex edge) {
            if (!straight.chain[edge].exists()) return;
            Chain& chain = chains_[straight.chain[edge]];
            any = any || !chain.is_restored;
            chain.is_restored = true;
        };
        for (const EdgeIndex e : duplicate_edges(straight)) restore(e);
        for (const EdgeIndex e :
             improperly_noded_edges(noded_.vertices, straight.edges, straight.changed, cut_.pool))
            restore(e);
        return any;
    }

    /// Restores the vertices of rings whose orientation has been inverted. A ring thinner than max_deviation
    /// can invert without a crossing. @return whether a chain was restored.
    bool restore_inverted_rings(const PerNode<char>& out) {
        bool any = false;
        PerHalfEdge<char> seen(boundary_.half_edge_count(), 0);
        for (const HalfEdgeIndex h : boundary_.half_edges()) {
            if (seen[h] || !boundary_.is_boundary[edge_of(h)] || !out[origin(h)]) continue;
            HalfEdgeIndex k = h;
            do {
                seen[k] = 1;
                k = next(k);
            } while (k != h);
            if (!is_inverted(h, out)) continue;
            do {
                if (const ChainIndex c = chain_of_[edge_of(k)]; c.exists()) {
                    any = any || !chains_[c].is_restored;
                    chains_[c].is_restored = true;
                }
                k = next(k);
            } while (k != h);
        }
        return any;
    }

    /// Whether the ring of half-edge h changes its orientation, or loses its area, without the vertices that
    /// are `out`.
    bool is_inverted(HalfEdgeIndex h, const PerNode<char>& out) const {
        const GridPoint& start = grid_point(origin(h));
        Int128 before = 0, after = 0;
        NodeIndex first = NodeIndex::none(), last = NodeIndex::none();
        HalfEdgeIndex k = h;
        do {
            const NodeIndex v = origin(k);
            before += twice_area(start, grid_point(v), grid_point(origin(twin(k))));
            k = next(k);
            if (out[v]) continue;
            if (last.exists()) after += twice_area(start, grid_point(last), grid_point(v));
            if (!first.exists()) first = v;
            last = v;
        } while (k != h);
        if (last.exists()) after += twice_area(start, grid_point(last), grid_point(first));
        return before > 0 ? after <= 0 : after >= 0;
    }

    /// Edges that occur twice. At least one of the two must have changed.
    std::vector<EdgeIndex> duplicate_edges(const StraightEdges& straight) const {
        const PerEdge<EdgeEnds>& edges = straight.edges;
        PerNode<char> at_changed(noded_.vertices.size(), 0);
        for (const EdgeIndex e : edges.indices())
            if (straight.changed[e]) at_changed[edges[e].first] = at_changed[edges[e].second] = 1;
        std::vector<EdgeIndex> order;
        for (const EdgeIndex e : edges.indices())
            if (at_changed[edges[e].first] && at_changed[edges[e].second]) order.push_back(e);
        std::sort(order.begin(), order.end(), [&](EdgeIndex e, EdgeIndex f) { return edges[e] < edges[f]; });
        std::vector<EdgeIndex> result;
        for (std::size_t k = 1; k < order.size(); ++k)
            if (edges[order[k]] == edges[order[k - 1]]) result.insert(result.end(), {order[k - 1], order[k]});
        return result;
    }

    const NodedEdges& noded_;
    const CutContext cut_;
    const BlockBoundary& boundary_;
    const PerEdge<EdgeMark>& marks_;
    PerNode<char> is_removable_;
    IndexedVector<ChainIndex, Chain> chains_;
    PerEdge<ChainIndex> chain_of_;  ///< none for an edge that is in no chain
};

}  // namespace

PerNode<char> redundant_vertices(const CutContext& cut, const BlockBoundary& boundary,
                                 const PerEdge<EdgeMark>& marks) {
    return BoundarySimplifier(cut, boundary, marks).run();
}

}  // namespace rockslope::blockgen
