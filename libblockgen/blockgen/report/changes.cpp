#include "blockgen/report/changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include "blockgen/faces/cut_context.hpp"
#include "common/base/disjoint_sets.hpp"

namespace rockslope::blockgen {

namespace {

double distance(const Point& p, const Point& a, const Point& b) {
    const double ux = b.x - a.x, uy = b.y - a.y, wx = p.x - a.x, wy = p.y - a.y;
    const double square = ux * ux + uy * uy;
    const double t = square > 0 ? std::clamp((wx * ux + wy * uy) / square, 0.0, 1.0) : 0;
    return std::hypot(wx - t * ux, wy - t * uy);
}

double distance(const Point& p, const std::vector<Point>& line, bool closed) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + (closed ? 0 : 1) < line.size(); ++k)
        smallest = std::min(smallest, distance(p, line[k], line[(k + 1) % line.size()]));
    return smallest;
}

/// The edges of all traces: those of trace t are edges[first[t]] ... edges[first[t + 1] - 1].
struct EdgesOfTraces {
    PerJointTrace<std::int32_t> first;
    std::vector<EdgeIndex> edges;

    EdgesOfTraces(const NodedEdges& noded, std::size_t traces, const SourceTable& table)
        : first(traces + 1, 0) {
        for_each(noded, table, [&](JointTraceIndex t, EdgeIndex) { ++first[t + 1]; });
        std::partial_sum(first.begin(), first.end(), first.begin());
        edges.resize(first.back());
        PerJointTrace<std::int32_t> fill(first.begin(), first.end() - 1);
        for_each(noded, table, [&](JointTraceIndex t, EdgeIndex e) { edges[fill[t]++] = e; });
    }

    std::span<const EdgeIndex> of(JointTraceIndex t) const {
        return std::span(edges).subspan(first[t], first[t + 1] - first[t]);
    }

  private:
    template <class Visit>
    static void for_each(const NodedEdges& noded, const SourceTable& table, const Visit& visit) {
        for (const EdgeIndex e : noded.edges.indices()) {
            SourceIndex last = SourceIndex::none();
            for (const EdgeSource& s : noded.sources_of(e)) {  // sorted by source
                if (!table.is_joint(s.source) || s.source == last) continue;
                last = s.source;
                visit(table.trace_of(s.source), e);
            }
        }
    }
};

/// An end of a trace and the vertex to which it was snapped.
struct TraceEnd {
    NodeIndex vertex;
    JointTraceIndex trace;
    Point point;
    double gap = std::numeric_limits<double>::infinity();  ///< m, distance to the nearest other source there
    SourceIndex other = SourceIndex::none();               ///< the nearest other source at the vertex
};

class JointChanges {
  public:
    explicit JointChanges(const CutContext& context)
        : context_(context), edges_(context.noded, context.traces.size(), context.table) {}

    std::vector<Change> run() {
        join_ends();
        for (const NearEnd& end : context_.model.trace_ends.joined)
            changes_.push_back({ChangeKind::end_snapped, end.at, 0, end.gap, end.joint, end.other});
        for (const NearEnd& end : context_.model.trace_ends.near_misses)
            changes_.push_back({ChangeKind::near_miss, end.at, 0, end.gap, end.joint, end.other});
        for (const JointTraceIndex t : indices<JointTraceIndex>(context_.traces.size())) {
            prune(t);
            if (t < context_.model.traces.size()) drop(t);
        }
        sort_changes(changes_);
        return std::move(changes_);
    }

  private:
    Point position(NodeIndex vertex) const {
        return context_.noded.frame.position(context_.noded.vertices[vertex]);
    }
    double length_of(EdgeIndex edge) const {
        const Point a = position(context_.noded.edges[edge].first),
                    b = position(context_.noded.edges[edge].second);
        return std::hypot(b.x - a.x, b.y - a.y);
    }

    /// The vertex of a trace nearest to its end p, if it is less than two grid steps away in x and y.
    std::optional<TraceEnd> end_at(JointTraceIndex t, const Point& p) const {
        double smallest = 2 * context_.noded.frame.step;
        std::optional<TraceEnd> end;
        for (const EdgeIndex e : edges_.of(t))
            for (const NodeIndex v : {context_.noded.edges[e].first, context_.noded.edges[e].second}) {
                const Point q = position(v);
                const double d = std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
                if (d >= smallest) continue;
                smallest = d;
                end = TraceEnd{v, t, p};
            }
        return end;
    }

    void join_ends() {
        std::vector<TraceEnd> ends;
        for (const JointTraceIndex t : indices<JointTraceIndex>(context_.traces.size()))
            for (const Point& p : {context_.traces[t].points.front(), context_.traces[t].points.back()})
                if (const auto end = end_at(t, p)) ends.push_back(*end);
        std::stable_sort(ends.begin(), ends.end(),
                         [](const TraceEnd& a, const TraceEnd& b) { return a.vertex < b.vertex; });
        PerNode<std::int32_t> first(context_.noded.vertices.size() + 1, 0);
        for (const TraceEnd& end : ends) ++first[end.vertex + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        for (const EdgeIndex e : context_.noded.edges.indices())
            for (const NodeIndex v : {context_.noded.edges[e].first, context_.noded.edges[e].second})
                for (std::int32_t k = first[v]; k < first[v + 1]; ++k)
                    for (const EdgeSource& s : context_.noded.sources_of(e)) note_source(ends[k], s.source);
        for (const TraceEnd& end : ends) add_joined(end);
    }

    void note_source(TraceEnd& end, SourceIndex source) const {
        if (source == context_.table.source_of(end.trace) || source == end.other) return;
        const double gap = distance_from(end.point, source);
        if (gap >= end.gap) return;
        end.gap = gap;
        end.other = source;
    }

    double distance_from(const Point& p, SourceIndex source) const {
        const auto part = [source](const auto& list, SourceIndex first) -> const auto& {
            return list[source - first];
        };
        if (context_.table.is_joint(source))
            return distance(p, part(context_.traces, context_.table.first_joint).points, false);
        if (source >= context_.table.first_tunnel)
            return distance(p, part(context_.model.tunnels, context_.table.first_tunnel).outline, true);
        if (context_.table.is_excavation(source))
            return distance(p, part(context_.model.excavations, context_.table.first_excavation).outline,
                            true);
        if (context_.table.is_region(source))
            return distance(p, part(context_.model.regions, context_.table.first_region).polygon, true);
        if (source >= context_.table.first_hole)
            return distance(p, part(context_.model.holes, context_.table.first_hole), true);
        double smallest = distance(p, context_.model.outline, true);
        for (const Ring& ring : context_.model.further_outlines)
            smallest = std::min(smallest, distance(p, ring, true));
        return smallest;
    }

    void add_joined(const TraceEnd& end) {
        // A gap within the rounding of the coordinates is ignored.
        const double rounding = 64 * std::numeric_limits<double>::epsilon() *
                                std::max(std::abs(end.point.x), std::abs(end.point.y));
        if (!end.other.exists() || !(end.gap > rounding)) return;
        Change change{
            ChangeKind::end_joined, position(end.vertex), 0, end.gap, name_of(end.trace), "outline"};
        if (context_.table.is_joint(end.other)) change.other = name_of(context_.table.trace_of(end.other));
        changes_.push_back(std::move(change));
    }

    /// The joint that counts along an edge with joints: the first.
    JointTraceIndex first_joint_of(EdgeIndex e) const {
        for (const EdgeSource& s : context_.noded.sources_of(e))
            if (context_.table.is_joint(s.source)) return context_.table.trace_of(s.source);
        return JointTraceIndex::none();
    }

    const std::string& name_of(JointTraceIndex trace) const { return context_.traces[trace].name; }

    /// Adds a change for each connected run of a trace's edges that have the same block on both sides.
    void prune(JointTraceIndex t) {
        std::vector<std::pair<NodeIndex, std::size_t>> ends;  // vertex, number of the pruned edge
        std::vector<EdgeIndex> pruned;
        for (const EdgeIndex e : edges_.of(t)) {
            const FaceBlockIndex left = context_.block_of(forward_half(e)),
                                 right = context_.block_of(backward_half(e));
            if (left != right || left == FaceBlocks::outside || first_joint_of(e) != t) continue;
            ends.emplace_back(context_.noded.edges[e].first, pruned.size());
            ends.emplace_back(context_.noded.edges[e].second, pruned.size());
            pruned.push_back(e);
        }
        if (pruned.empty()) return;
        std::sort(ends.begin(), ends.end());
        DisjointSets runs(pruned.size());
        for (std::size_t k = 1; k < ends.size(); ++k)
            if (ends[k].first == ends[k - 1].first) runs.unite(ends[k].second, ends[k - 1].second);

        struct Run {
            double length = 0;
            NodeIndex first = std::numeric_limits<std::int32_t>::max(), last = NodeIndex::none();
        };
        std::vector<Run> of_root(pruned.size());
        for (std::size_t k = 0; k < pruned.size(); ++k) {
            Run& run = of_root[runs.root(k)];
            run.length += length_of(pruned[k]);
            run.first = std::min(run.first, context_.noded.edges[pruned[k]].first);
            run.last = std::max(run.last, context_.noded.edges[pruned[k]].second);
        }
        for (const Run& run : of_root) {
            if (!run.last.exists()) continue;
            const Point a = position(run.first), b = position(run.last);
            changes_.push_back({ChangeKind::piece_pruned,
                                {(a.x + b.x) / 2, (a.y + b.y) / 2},
                                0,
                                run.length,
                                context_.traces[t].name,
                                {}});
        }
    }

    /// Adds a change for a given trace if no piece of it lies inside the rock.
    void drop(JointTraceIndex t) {
        bool in_rock = false, on_face = false;
        for (const EdgeIndex e : edges_.of(t)) {
            const bool left = context_.block_of(forward_half(e)) != FaceBlocks::outside,
                       right = context_.block_of(backward_half(e)) != FaceBlocks::outside;
            in_rock = in_rock || (left && right);
            on_face = on_face || left != right;
        }
        if (in_rock || (on_face && context_.model.outline_of_traces)) return;
        double length = 0;
        const std::vector<Point>& points = context_.traces[t].points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            length += std::hypot(points[k + 1].x - points[k].x, points[k + 1].y - points[k].y);
        const ChangeKind kind = on_face                              ? ChangeKind::trace_on_free_face
                                : length < context_.noded.frame.step ? ChangeKind::trace_without_length
                                                                     : ChangeKind::trace_outside;
        const Point &a = points.front(), &b = points.back();
        changes_.push_back(
            {kind, {(a.x + b.x) / 2, (a.y + b.y) / 2}, 0, length, context_.traces[t].name, {}});
    }

    CutContext context_;
    EdgesOfTraces edges_;
    std::vector<Change> changes_;
};

}  // namespace

const char* label_of(ChangeKind kind) {
    switch (kind) {
        case ChangeKind::block_merged:
            return "small block merged";
        case ChangeKind::piece_dropped:
            return "joint dropped beside small block";
        case ChangeKind::island_filled:
            return "island filled";
        case ChangeKind::island_cut:
            return "island cut";
        case ChangeKind::end_joined:
            return "end joined";
        case ChangeKind::end_snapped:
            return "end moved by snap";
        case ChangeKind::near_miss:
            return "end stops short (not changed)";
        case ChangeKind::piece_pruned:
            return "joint piece pruned";
        case ChangeKind::joint_repeated:
            return "joint along an earlier one";
        case ChangeKind::trace_outside:
            return "trace outside the rock dropped";
        case ChangeKind::trace_on_free_face:
            return "trace along a free face dropped";
        case ChangeKind::trace_without_length:
            return "trace without length dropped";
    }
    return "";
}

void sort_changes(std::vector<Change>& changes) {
    std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
        return std::tuple(a.kind, a.at.x, a.at.y, a.length) < std::tuple(b.kind, b.at.x, b.at.y, b.length);
    });
}

std::vector<Change> joint_changes(const CutContext& cut) {
    return JointChanges(cut).run();
}

}  // namespace rockslope::blockgen
