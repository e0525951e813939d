#include "blockgen/cut/simplify_boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rockslope::blockgen {

namespace {

constexpr double max_deviation = 2;  // grid cells

/// A chain of boundary edges between two vertices that are not removable.
struct Chain {
    std::vector<std::int32_t> vertices;
    bool is_exact = false;     ///< along the outline of the rock
    bool is_restored = false;  ///< all its vertices are kept
};

class BoundarySimplifier {
  public:
    BoundarySimplifier(const NodedEdges& noded, const Subdivision& subdivision, const FaceBlocks& faces,
                       const BlockBoundary& boundary, const std::vector<EdgeMark>& marks)
        : noded_(noded), subdivision_(subdivision), faces_(faces), boundary_(boundary), marks_(marks) {
        find_removable_vertices();
        find_chains();
    }

    std::vector<char> run() {
        while (true) {
            std::vector<char> out(noded_.vertices.size(), 0);
            std::vector<std::pair<std::int32_t, std::int32_t>> edges;
            std::vector<std::size_t> chain_of_edge;
            std::vector<char> changed;
            for (std::size_t c = 0; c < chains_.size(); ++c) {
                const std::vector<std::int32_t>& all = chains_[c].vertices;
                const std::vector<std::int32_t> kept = kept_vertices(chains_[c]);
                for (std::size_t k = 1; k + 1 < all.size(); ++k) out[all[k]] = 1;
                for (const std::int32_t v : kept) out[v] = 0;
                for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
                    edges.push_back(std::minmax({kept[k], kept[k + 1]}));
                    chain_of_edge.push_back(c);
                    changed.push_back(kept.size() < all.size());
                }
            }
            if (!restore_improperly_noded(edges, chain_of_edge, changed) && !restore_inverted_rings(out))
                return out;
        }
    }

  private:
    void find_removable_vertices() {
        std::vector<int> degree(noded_.vertices.size(), 0);
        std::vector<std::int32_t> one_edge(noded_.vertices.size(), -1);
        is_removable_.assign(noded_.vertices.size(), 1);
        for (std::size_t e = 0; e < noded_.edges.size(); ++e) {
            if (!boundary_.is_boundary[e]) continue;
            for (const std::int32_t v : {noded_.edges[e].first, noded_.edges[e].second}) {
                const std::size_t i = v;
                ++degree[i];
                if (one_edge[i] >= 0 && !(marks_[one_edge[i]] == marks_[e])) is_removable_[i] = 0;
                one_edge[i] = e;
            }
        }
        for (std::size_t i = 0; i < is_removable_.size(); ++i)
            is_removable_[i] = is_removable_[i] && degree[i] == 2;
    }

    std::size_t origin(std::size_t h) const { return boundary_.origin[h]; }

    void find_chains() {
        std::vector<char> used(noded_.edges.size(), 0);
        chain_of_.assign(noded_.edges.size(), -1);
        for (std::size_t h = 0; h < boundary_.next.size(); ++h)
            if (boundary_.is_boundary[h / 2] && !used[h / 2] && !is_removable_[origin(h)]) walk(h, used);
        // The remaining edges form closed rings of removable vertices, which are opened at their smallest
        // vertex.
        for (std::size_t h = 0; h < boundary_.next.size(); ++h) {
            if (!boundary_.is_boundary[h / 2] || used[h / 2]) continue;
            std::size_t smallest = h;
            for (std::size_t k = next(h); k != h; k = next(k))
                if (origin(k) < origin(smallest)) smallest = k;
            is_removable_[origin(smallest)] = 0;
            walk(smallest, used);
        }
    }

    std::size_t next(std::size_t h) const { return boundary_.next[h]; }

    void walk(std::size_t h, std::vector<char>& used) {
        Chain chain;
        const auto block = [&](std::size_t k) { return faces_.block[subdivision_.face[k]]; };
        chain.is_exact = block(h) == FaceBlocks::outside || block(h ^ 1u) == FaceBlocks::outside;
        chain.vertices.push_back(origin(h));
        for (std::size_t k = h;; k = next(k)) {
            used[k / 2] = 1;
            chain_of_[k / 2] = static_cast<std::int32_t>(chains_.size());
            chain.vertices.push_back(boundary_.origin[k ^ 1u]);
            if (!is_removable_[origin(k ^ 1u)]) break;
        }
        chains_.push_back(std::move(chain));
    }

    const GridPoint& grid_point(std::int32_t v) const { return noded_.vertices[v]; }

    /// Distance of v from the line a-b, or from a when a equals b, in cells. With `exact`, a vertex off the
    /// line is at least twice max_deviation away.
    double distance(std::int32_t a, std::int32_t b, std::int32_t v, bool exact) const {
        const GridPoint &p = grid_point(a), &q = grid_point(b), &r = grid_point(v);
        const Int128 area = twice_area(p, q, r);
        if (a != b && area == 0) return 0;
        if (a == b) return std::hypot(static_cast<double>(r.x - p.x), static_cast<double>(r.y - p.y));
        const double height = std::abs(static_cast<double>(area)) /
                              std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
        return exact ? std::max(height, 2 * max_deviation) : height;
    }

    /// Line simplification by Douglas and Peucker (1973) between the chain's ends.
    std::vector<std::int32_t> kept_vertices(const Chain& chain) const {
        if (chain.is_restored || chain.vertices.size() == 2) return chain.vertices;
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
        std::vector<std::int32_t> kept;
        for (std::size_t k = 0; k < keep.size(); ++k)
            if (keep[k]) kept.push_back(chain.vertices[k]);
        return kept;
    }

    /// Restores the vertices of chains that now share an edge, cross another chain or pass too near a vertex.
    /// @return whether a chain was restored.
    bool restore_improperly_noded(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
                                  const std::vector<std::size_t>& chain_of_edge,
                                  const std::vector<char>& changed) {
        if (std::find(changed.begin(), changed.end(), 1) == changed.end()) return false;
        bool any = false;
        const auto restore = [&](std::size_t edge) {
            Chain& chain = chains_[chain_of_edge[edge]];
            any = any || !chain.is_restored;
            chain.is_restored = true;
        };
        for (const std::size_t e : duplicate_edges(edges, changed)) restore(e);
        for (const std::size_t e : improperly_noded_edges(noded_.vertices, edges, changed)) restore(e);
        return any;
    }

    /// Restores the vertices of rings whose orientation has been inverted. A ring thinner than max_deviation
    /// can invert without a crossing. @return whether a chain was restored.
    bool restore_inverted_rings(const std::vector<char>& out) {
        bool any = false;
        std::vector<char> seen(boundary_.next.size(), 0);
        for (std::size_t h = 0; h < boundary_.next.size(); ++h) {
            if (!boundary_.is_boundary[h / 2] || seen[h]) continue;
            std::size_t k = h;
            do {
                seen[k] = 1;
                k = next(k);
            } while (k != h);
            if (!is_inverted(h, out)) continue;
            do {
                Chain& chain = chains_[chain_of_[k / 2]];
                any = any || !chain.is_restored;
                chain.is_restored = true;
                k = next(k);
            } while (k != h);
        }
        return any;
    }

    /// Whether the ring of half-edge h changes its orientation, or loses its area, without the vertices that
    /// are `out`.
    bool is_inverted(std::size_t h, const std::vector<char>& out) const {
        const GridPoint& start = noded_.vertices[origin(h)];
        Int128 before = 0, after = 0;
        std::int32_t first = -1, last = -1;
        bool has_removed = false;
        std::size_t k = h;
        do {
            const std::int32_t v = origin(k);
            before += twice_area(start, grid_point(v), grid_point(boundary_.origin[k ^ 1u]));
            k = next(k);
            if (out[v]) {
                has_removed = true;
                continue;
            }
            if (last >= 0) after += twice_area(start, grid_point(last), grid_point(v));
            if (first < 0) first = v;
            last = v;
        } while (k != h);
        if (!has_removed) return false;
        if (last >= 0) after += twice_area(start, grid_point(last), grid_point(first));
        return before > 0 ? after <= 0 : after >= 0;
    }

    /// Edges that occur twice. At least one of the two must have changed.
    std::vector<std::size_t> duplicate_edges(const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
                                             const std::vector<char>& changed) const {
        std::vector<char> at_changed(noded_.vertices.size(), 0);
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (changed[e]) at_changed[edges[e].first] = at_changed[edges[e].second] = 1;
        std::vector<std::size_t> order;
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (at_changed[edges[e].first] && at_changed[edges[e].second]) order.push_back(e);
        std::sort(order.begin(), order.end(),
                  [&](std::size_t e, std::size_t f) { return edges[e] < edges[f]; });
        std::vector<std::size_t> result;
        for (std::size_t k = 1; k < order.size(); ++k)
            if (edges[order[k]] == edges[order[k - 1]]) result.insert(result.end(), {order[k - 1], order[k]});
        return result;
    }

    const NodedEdges& noded_;
    const Subdivision& subdivision_;
    const FaceBlocks& faces_;
    const BlockBoundary& boundary_;
    const std::vector<EdgeMark>& marks_;
    std::vector<char> is_removable_;
    std::vector<Chain> chains_;
    std::vector<std::int32_t> chain_of_;  ///< per edge; -1 when it is not on a block boundary
};

}  // namespace

std::vector<char> redundant_vertices(const NodedEdges& noded, const Subdivision& subdivision,
                                     const FaceBlocks& faces, const BlockBoundary& boundary,
                                     const std::vector<EdgeMark>& marks) {
    return BoundarySimplifier(noded, subdivision, faces, boundary, marks).run();
}

}  // namespace rockslope::blockgen
