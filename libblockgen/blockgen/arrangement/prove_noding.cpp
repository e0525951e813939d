#include "blockgen/arrangement/prove_noding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

#include "blockgen/arrangement/exact_network.hpp"
#include "blockgen/arrangement/noding_courses.hpp"
#include "common/base/text.hpp"

namespace rockslope::blockgen {

namespace {

using Sources = std::vector<SourceIndex>;

double extent_of(std::span<const SourceSegment> segments) {
    Point low = segments.front().a, high = low;
    for (const SourceSegment& s : segments)
        for (const Point& p : {s.a, s.b}) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    return std::max(high.x - low.x, high.y - low.y);
}

/// The sources of the edges at each node, ascending.
PerNode<Sources> sources_at_nodes(const NodedEdges& noded) {
    PerNode<Sources> sources(noded.vertices.size());
    for (const EdgeIndex e : noded.edges.indices())
        for (const EdgeSource& s : noded.sources_of(e)) {
            sources[noded.edges[e].first].push_back(s.source);
            sources[noded.edges[e].second].push_back(s.source);
        }
    for (Sources& at_node : sources) {
        std::sort(at_node.begin(), at_node.end());
        at_node.erase(std::unique(at_node.begin(), at_node.end()), at_node.end());
    }
    return sources;
}

/// Compares the points and faces of the exact arrangement with the nodes and faces after noding.
class NetworkComparison {
  public:
    NetworkComparison(std::span<const SourceSegment> segments, const NodedEdges& noded,
                      const Subdivision& subdivision, const NodingBounds& bounds,
                      const std::vector<char>& is_collapsed)
        : segments_(segments),
          noded_(noded),
          subdivision_(subdivision),
          bounds_(bounds),
          is_collapsed_(is_collapsed),
          exact_(arrange_segments(segments, noded.frame)),
          nodes_(noded.vertices),
          sources_at_(sources_at_nodes(noded)),
          node_of_(exact_.vertices.size(), NodeIndex::none()),
          points_in_(noded.vertices.size(), 0),
          is_changed_(noded.vertices.size(), 0),
          is_kept_(noded.edges.size(), 0) {}

    void run(NodingProof& proof) {
        for (std::size_t v = 0; v < exact_.vertices.size(); ++v) find_node(v);
        for (std::size_t v = 0; v < exact_.vertices.size(); ++v) require_common_node(v);
        for (std::size_t v = 0; v < exact_.vertices.size(); ++v) flag_collapse(v);
        require_crossings();
        flag_changes(proof);
        flag_kept_edges();
        compare_faces(proof);
    }

  private:
    /// The sources of the segments through a point, without segments that collapsed, ascending.
    Sources sources_of(std::size_t v) const {
        Sources sources;
        for (const std::int32_t k : exact_.segments_at[v])
            if (!is_collapsed_[k]) sources.push_back(segments_[k].source);
        std::sort(sources.begin(), sources.end());
        sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
        return sources;
    }

    /// Whether a segment passes through a point at which only segments that collapsed meet it: they are gone,
    /// and it needs no node there.
    bool only_touched_by_collapsed(std::size_t v) const {
        const std::vector<std::int32_t>& through = exact_.segments_at[v];
        const auto is_left = [&](std::int32_t k) { return !is_collapsed_[k]; };
        if (std::count_if(through.begin(), through.end(), is_left) != 1) return false;
        const SourceSegment& left = segments_[*std::find_if(through.begin(), through.end(), is_left)];
        const Point p = place(exact_.vertices[v]);
        const double nearest =
            std::min(std::hypot(p.x - left.a.x, p.y - left.a.y), std::hypot(p.x - left.b.x, p.y - left.b.y));
        return nearest > noded_.frame.step * bounds_.rounding;
    }

    /// How far the crossing of segments may move as their ends are rounded, cells.
    double crossing_shift(std::size_t v) const {
        const std::vector<std::int32_t>& through = exact_.segments_at[v];
        const auto direction = [&](std::int32_t k) {
            const SourceSegment& s = segments_[k];
            const double length = std::hypot(s.b.x - s.a.x, s.b.y - s.a.y);
            return Point{(s.b.x - s.a.x) / length, (s.b.y - s.a.y) / length};
        };
        double sine = 1;
        for (std::size_t i = 1; i < through.size(); ++i) {
            const Point u = direction(through[0]), w = direction(through[i]);
            sine = std::min(sine, std::abs(u.x * w.y - u.y * w.x));
        }
        return through.size() < 2 ? 0 : 2 * std::numbers::sqrt2 * bounds_.rounding / std::max(sine, 1e-12);
    }

    /// The node in the cell of a point, if there is one and no other within rounding.
    void find_node(std::size_t v) {
        const std::vector<NodeIndex> own = nodes_.within(exact_.vertices[v], 0.5 + bounds_.rounding);
        if (own.size() != 1) return;
        node_of_[v] = own[0];
        ++points_in_[own[0]];
    }

    bool has_sources(NodeIndex node, const Sources& sources) const {
        return std::includes(sources_at_[node].begin(), sources_at_[node].end(), sources.begin(),
                             sources.end());
    }

    /// A point without a node in its cell was merged into that of another point or of bent segments, or is a
    /// crossing at a small angle. @throws std::logic_error when no such node has all its sources.
    void require_common_node(std::size_t v) {
        const Sources sources = sources_of(v);
        if (sources.empty() || only_touched_by_collapsed(v)) return;
        if (node_of_[v].exists() && has_sources(node_of_[v], sources)) return;
        const double shift = crossing_shift(v);
        for (const NodeIndex node : nodes_.within(exact_.vertices[v], 1.5 + bounds_.rounding + shift))
            if (has_sources(node, sources)) {
                is_changed_[node] = 1;
                return;
            }
        fail(place(exact_.vertices[v]), "no node joins the segments that meet");
    }

    /// Nodes beside a point of a segment that collapsed: what it was joined to is left.
    void flag_collapse(std::size_t v) {
        const std::vector<std::int32_t>& through = exact_.segments_at[v];
        if (std::none_of(through.begin(), through.end(), [&](std::int32_t k) { return is_collapsed_[k]; }))
            return;
        for (const NodeIndex node : nodes_.within(exact_.vertices[v], 1.5 + bounds_.rounding))
            is_changed_[node] = 1;
    }

    /// A node without a point, into which none was merged, is where bent segments cross.
    /// @throws std::logic_error when one segment has a bend there by itself.
    void require_crossings() const {
        PerNode<std::int32_t> degree(noded_.vertices.size(), 0);
        for (const auto& [a, b] : noded_.edges) ++degree[a], ++degree[b];
        for (const NodeIndex node : degree.indices())
            if (points_in_[node] == 0 && !is_changed_[node] && degree[node] < 3 &&
                sources_at_[node].size() < 2)
                fail(noded_.frame.position(noded_.vertices[node]), "a segment has a node without a point");
    }

    void flag_changes(NodingProof& proof) {
        for (std::size_t v = 0; v < exact_.vertices.size(); ++v)
            if (const NodeIndex node = node_of_[v]; node.exists() && sources_of(v) != sources_at_[node])
                is_changed_[node] = 1;
        for (const NodeIndex node : is_changed_.indices()) {
            if (points_in_[node] != 1) is_changed_[node] = 1;
            if (!is_changed_[node]) continue;
            if (proof.changed_nodes++ == 0) proof.first_change = noded_.frame.position(noded_.vertices[node]);
        }
    }

    /// The half-edge between the nodes of two points; none where the nodes are changed or not joined.
    HalfEdgeIndex half_edge(std::int32_t v, std::int32_t w) const {
        const NodeIndex a = node_of_[v], b = node_of_[w];
        if (!a.exists() || !b.exists() || is_changed_[a] || is_changed_[b]) return HalfEdgeIndex::none();
        const EdgeEnds ends(std::min(a, b), std::max(a, b));
        const auto found = std::lower_bound(noded_.edges.begin(), noded_.edges.end(), ends);
        if (found == noded_.edges.end() || *found != ends) return HalfEdgeIndex::none();
        const EdgeIndex edge = static_cast<std::int32_t>(found - noded_.edges.begin());
        return a < b ? forward_half(edge) : backward_half(edge);
    }

    /// The half-edges of a cycle; nothing when one of them is missing.
    std::vector<HalfEdgeIndex> half_edges(const std::vector<std::int32_t>& cycle) const {
        std::vector<HalfEdgeIndex> halves;
        for (std::size_t k = 0; k < cycle.size(); ++k) {
            const HalfEdgeIndex half = half_edge(cycle[k], cycle[(k + 1) % cycle.size()]);
            if (!half.exists()) return {};
            halves.push_back(half);
        }
        return halves;
    }

    /// Flags the edges that were one edge before.
    void flag_kept_edges() {
        for (const auto& face : exact_.faces)
            for (const auto& cycle : face)
                for (std::size_t k = 0; k < cycle.size(); ++k)
                    if (const HalfEdgeIndex half = half_edge(cycle[k], cycle[(k + 1) % cycle.size()]);
                        half.exists())
                        is_kept_[half.value() / 2] = 1;
    }

    /// Whether all segments of a cycle collapsed, so that nothing of it is left.
    bool is_gone(const std::vector<std::int32_t>& cycle) const {
        return std::all_of(cycle.begin(), cycle.end(), [&](std::int32_t v) { return sources_of(v).empty(); });
    }

    void compare_faces(NodingProof& proof) {
        PerFace<std::int32_t> half_edges_of(subdivision_.face_count, 0);
        for (const FaceIndex face : subdivision_.face) ++half_edges_of[face];
        PerFace<char> is_equal(subdivision_.face_count, 0);
        for (const auto& cycles : exact_.faces) {
            const FaceIndex face = equal_face(cycles, half_edges_of);
            if (face.exists()) is_equal[face] = 1;
        }
        require_changes(is_equal);
        proof.faces_before = exact_.faces.size() - 1;
        proof.faces_after = subdivision_.face_count - 1;
        proof.equal_faces = std::accumulate(is_equal.begin() + 1, is_equal.end(), std::size_t{0});
    }

    /// The face after noding with the same cycles, none for a face at which something was changed.
    /// @throws std::logic_error when nothing was changed and the faces differ.
    FaceIndex equal_face(const std::vector<std::vector<std::int32_t>>& cycles,
                         const PerFace<std::int32_t>& half_edges_of) const {
        std::vector<std::vector<HalfEdgeIndex>> all;
        for (const auto& cycle : cycles) {
            if (is_gone(cycle)) continue;
            all.push_back(half_edges(cycle));
            if (all.back().empty()) return FaceIndex::none();
        }
        if (all.empty()) return FaceIndex::none();
        const FaceIndex face = subdivision_.face[all[0][0]];
        std::size_t count = 0;
        for (const auto& cycle : all) {
            count += cycle.size();
            for (std::size_t k = 0; k < cycle.size(); ++k)
                if (subdivision_.next[cycle[k]] != cycle[(k + 1) % cycle.size()] ||
                    subdivision_.face[cycle[k]] != face)
                    fail(position(cycle[k]), "the edges round a face are others than before");
        }
        if (count != static_cast<std::size_t>(half_edges_of[face]))
            fail(position(all[0][0]), "a joint came to lie in another face");
        return face;
    }

    /// @throws std::logic_error when a face without a counterpart has no changed node nor a bent edge.
    void require_changes(const PerFace<char>& is_equal) const {
        PerFace<char> is_explained = is_equal;
        PerFace<HalfEdgeIndex> first(subdivision_.face_count, HalfEdgeIndex::none());
        for (const HalfEdgeIndex half : subdivision_.face.indices()) {
            const FaceIndex face = subdivision_.face[half];
            first[face] = half;
            const auto& [a, b] = noded_.edges[half.value() / 2];
            if (is_changed_[a] || is_changed_[b] || !is_kept_[half.value() / 2]) is_explained[face] = 1;
        }
        for (const FaceIndex face : is_explained.indices())
            if (!is_explained[face] && first[face].exists())
                fail(position(first[face]), "a face is new, and no node of it was changed");
    }

    Point place(const Point& cells) const {
        return {noded_.frame.origin.x + noded_.frame.step * cells.x,
                noded_.frame.origin.y + noded_.frame.step * cells.y};
    }
    Point position(HalfEdgeIndex half) const {
        return noded_.frame.position(noded_.vertices[noded_.edges[half.value() / 2].first]);
    }
    [[noreturn]] static void fail(const Point& p, const std::string& what) {
        throw std::logic_error("noding: " + what + " at (" + shortest_text(p.x) + ", " + shortest_text(p.y) +
                               ")");
    }

    std::span<const SourceSegment> segments_;
    const NodedEdges& noded_;
    const Subdivision& subdivision_;
    NodingBounds bounds_;
    const std::vector<char>& is_collapsed_;
    ExactNetwork exact_;
    NodesByPlace nodes_;
    PerNode<Sources> sources_at_;
    std::vector<NodeIndex> node_of_;   ///< of each point: that in its cell, or none
    PerNode<std::int32_t> points_in_;  ///< number of points with this node
    PerNode<char> is_changed_;
    PerEdge<char> is_kept_;
};

}  // namespace

NodingProof prove_noding(std::span<const SourceSegment> segments, const NodedEdges& noded,
                         const Subdivision& subdivision) {
    NodingProof proof;
    if (segments.empty()) return proof;
    const NodingBounds bounds = noding_bounds(noded, extent_of(segments));
    const std::vector<char> is_collapsed = prove_courses(segments, noded, bounds);
    for (const SourceSegment& s : segments) proof.segments += s.a != s.b;
    proof.collapsed = std::count(is_collapsed.begin(), is_collapsed.end(), 1);
    NetworkComparison(segments, noded, subdivision, bounds, is_collapsed).run(proof);
    return proof;
}

}  // namespace rockslope::blockgen
