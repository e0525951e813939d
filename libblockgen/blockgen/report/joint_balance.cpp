#include "blockgen/report/joint_balance.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "blockgen/input/domain.hpp"
#include "blockgen/report/cut_context.hpp"
#include "blockgen/sampling/rock_domain.hpp"

namespace rockslope::blockgen {

namespace {

double length_of(const Trace& trace) {
    double length = 0;
    for (std::size_t k = 0; k + 1 < trace.points.size(); ++k)
        length +=
            std::hypot(trace.points[k + 1].x - trace.points[k].x, trace.points[k + 1].y - trace.points[k].y);
    return length;
}

/// The point half way along.
Point middle_of(const Trace& trace) {
    double left = length_of(trace) / 2;
    for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
        const Point &a = trace.points[k], &b = trace.points[k + 1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (left <= length && length > 0)
            return {a.x + left / length * (b.x - a.x), a.y + left / length * (b.y - a.y)};
        left -= length;
    }
    return trace.points.back();
}

bool is_in_rock(const SlopeModel& model, const Point& p) {
    if (!is_in_outlines(model, p)) return false;
    for (const Ring& hole : model.holes)
        if (side_of_ring(hole, p) > 0) return false;
    for (const Tunnel& tunnel : model.tunnels)
        if (side_of_ring(tunnel.outline, p) > 0) return false;
    return true;
}

/// Sums of length over directions, of which the mean direction and the spread across it follow. Directions of
/// joints are axes: angles count twice.
struct AxialSums {
    double length = 0, cosine = 0, sine = 0;

    void add(double dx, double dy) {
        const double l = std::hypot(dx, dy), angle = 2 * std::atan2(dy, dx);
        length += l;
        cosine += l * std::cos(angle);
        sine += l * std::sin(angle);
    }
    double mean_direction() const { return std::atan2(sine, cosine) / 2; }
};

/// What became of the length of one trace.
struct TraceLengths {
    double retained = 0, pruned = 0, on_boundary = 0, outside = 0;
    std::size_t edges = 0;
    double in_rock() const { return retained + pruned; }
    double inside_box() const { return in_rock() + on_boundary + outside; }
};

class NetworkMeasure {
  public:
    explicit NetworkMeasure(const CutContext& parts) : context_(parts), trace_lengths_(parts.traces.size()) {
        assign_rows();
    }

    NetworkReport run(double rock_area) {
        add_edges();
        for (std::size_t t = 0; t < context_.traces.size(); ++t) add_trace(t);
        for (std::size_t r = 0; r < report_.joints.size(); ++r) {
            JointBalance& b = report_.joints[r];
            const JointSet* set = set_of(b.name);
            const bool is_local = set != nullptr && !set->region.empty();
            const double area = is_local ? RockDomain(context_.model, set->region).area() : rock_area;
            b.p10 = across_[r] / area;
            b.p20 /= area;
            b.p21 = (b.retained + b.pruned) / area;
            if (set != nullptr) set_targets(*set, b);
        }
        count_nodes();
        warn();
        return std::move(report_);
    }

  private:
    void assign_rows() {
        std::unordered_map<std::string, std::size_t> row_of_name;
        for (const Trace& trace : context_.traces) {
            const auto [found, is_new] = row_of_name.emplace(trace.name, report_.joints.size());
            if (is_new) report_.joints.push_back({trace.name});
            row_.push_back(found->second);
        }
        sums_.resize(report_.joints.size());
        across_.resize(report_.joints.size());
    }

    const JointSet* set_of(const std::string& name) const {
        for (const JointSet& set : context_.model.joint_sets)
            if (set.name == name) return &set;
        return nullptr;
    }

    static void set_targets(const JointSet& set, JointBalance& b) {
        using Measure = StopRule::Measure;
        if (set.stop.measure == Measure::p10) b.p10_target = set.stop.target;
        if (set.stop.measure == Measure::p20) b.p20_target = set.stop.target;
        if (set.stop.measure == Measure::p21) b.p21_target = set.stop.target;
        if (set.stop.measure == Measure::count) b.count_target = set.stop.target;
        if (set.kind != SetKind::parallel && set.kind != SetKind::cross_jointed) return;
        b.p10_target = 1 / set.spacing.truncated_mean();
        if (set.trace_length) {
            const double open = set.trace_length->truncated_mean();
            b.p10_target *= open / (open + set.gap->truncated_mean());
        }
        if (!set.orientation.has_scatter()) b.p21_target = b.p10_target;
    }

    /// Along which a trace's length counts for P10: a set's own mean direction, whatever its joints came out
    /// as, or the mean of given traces.
    double mean_direction(std::size_t row) const {
        const JointSet* set = set_of(report_.joints[row].name);
        return set != nullptr && set->kind != SetKind::voronoi ? set->orientation.mean_angle()
                                                               : sums_[row].mean_direction();
    }

    bool is_rock(std::size_t half_edge) const { return context_.block_of(half_edge) != FaceBlocks::outside; }
    Point vector_of(std::size_t e) const {
        const GridPoint& a = context_.noded.vertices[static_cast<std::size_t>(context_.noded.edges[e].first)];
        const GridPoint& b =
            context_.noded.vertices[static_cast<std::size_t>(context_.noded.edges[e].second)];
        return {context_.noded.frame.step * static_cast<double>(b.x - a.x),
                context_.noded.frame.step * static_cast<double>(b.y - a.y)};
    }

    template <class Visit>
    void for_each_joint_of(std::size_t edge, const Visit& visit) const {
        std::int32_t last = -1;
        for (const EdgeSource& s : context_.noded.sources_of(edge)) {  // sorted by source
            if (!context_.table.is_joint(s.source) || s.source == last) continue;
            last = s.source;
            visit(static_cast<std::size_t>(s.source - context_.table.first_joint));
        }
    }

    void add_edges() {
        for (std::size_t e = 0; e < context_.noded.edges.size(); ++e)
            for_each_joint_of(e, [&](std::size_t t) { add_edge(e, t); });
        std::vector<Point> mean;
        for (std::size_t r = 0; r < sums_.size(); ++r) {
            const double angle = mean_direction(r);
            mean.push_back({std::cos(angle), std::sin(angle)});
        }
        for (std::size_t e = 0; e < context_.noded.edges.size(); ++e)
            for_each_joint_of(e, [&](std::size_t t) {
                if (!is_rock(2 * e) || !is_rock(2 * e + 1)) return;
                const Point v = vector_of(e), u = mean[row_[t]];
                across_[row_[t]] += std::abs(v.x * u.x + v.y * u.y);
            });
    }

    void add_edge(std::size_t e, std::size_t t) {
        const Point v = vector_of(e);
        const double length = std::hypot(v.x, v.y);
        const bool left = is_rock(2 * e), right = is_rock(2 * e + 1);
        TraceLengths& lengths = trace_lengths_[t];
        ++lengths.edges;
        if (left != right)
            lengths.on_boundary += length;
        else if (!left)
            lengths.outside += length;
        else
            (context_.block_of(2 * e) == context_.block_of(2 * e + 1) ? lengths.pruned : lengths.retained) +=
                length;
        if (left && right) sums_[row_[t]].add(v.x, v.y);
    }

    void add_trace(std::size_t t) {
        TraceLengths& lengths = trace_lengths_[t];
        JointBalance& b = report_.joints[row_[t]];
        const double input = length_of(context_.traces[t]);
        // Every piece may be longer or shorter by what its two ends moved; a trace that runs back over itself
        // counts once.
        const double tolerance = 2 * context_.noded.largest_snap *
                                     static_cast<double>(lengths.edges + context_.traces[t].points.size()) +
                                 1e-9 * input;
        if (lengths.inside_box() > input + tolerance)
            throw std::logic_error("joint '" + context_.traces[t].name + "' grew when it was noded");
        ++b.traces;
        b.input += input;
        b.retained += lengths.retained;
        b.pruned += lengths.pruned;
        b.on_boundary += lengths.on_boundary;
        // What was clipped away beyond the domain's box belongs here too.
        b.outside += std::max(lengths.outside, input - lengths.in_rock() - lengths.on_boundary);
        b.p20 += is_in_rock(context_.model, middle_of(context_.traces[t]));
    }

    void count_nodes() {
        std::vector<unsigned char> branches(context_.noded.vertices.size(), 0),
            at_face(context_.noded.vertices.size(), 0);
        for (std::size_t e = 0; e < context_.noded.edges.size(); ++e) {
            const auto sources = context_.noded.sources_of(e);
            const bool is_joint = std::any_of(sources.begin(), sources.end(), [&](const EdgeSource& s) {
                return context_.table.is_joint(s.source);
            });
            for (const std::int32_t v : {context_.noded.edges[e].first, context_.noded.edges[e].second}) {
                const auto i = static_cast<std::size_t>(v);
                if (is_rock(2 * e) != is_rock(2 * e + 1)) at_face[i] = 1;
                if (is_joint && is_rock(2 * e) && is_rock(2 * e + 1) && branches[i] < 255) ++branches[i];
            }
        }
        NodeCounts& n = report_.nodes;
        for (std::size_t v = 0; v < branches.size(); ++v) {
            if (branches[v] == 0) continue;
            if (at_face[v])
                ++n.edge;
            else if (branches[v] != 2)
                ++(branches[v] == 1 ? n.i : branches[v] == 3 ? n.y : n.x);
        }
    }

    /// Only traces that somebody drew: sampled sets fill the domain's box, so that some lie beside the rock.
    void warn() {
        struct Idle {
            std::size_t points = 0, outside = 0, on_boundary = 0;
        };
        std::vector<Idle> idle(report_.joints.size());
        for (std::size_t t = 0; t < std::min(context_.traces.size(), context_.model.traces.size()); ++t) {
            const TraceLengths& lengths = trace_lengths_[t];
            Idle& row = idle[row_[t]];
            if (lengths.in_rock() > 0) continue;
            if (lengths.on_boundary > 0)
                row.on_boundary += !context_.model.outline_of_traces;
            else
                ++(length_of(context_.traces[t]) < context_.noded.frame.step ? row.points : row.outside);
        }
        for (std::size_t r = 0; r < idle.size(); ++r) {
            say(r, idle[r].points, "has no length on this grid and is dropped",
                "have no length on this grid and are dropped");
            say(r, idle[r].outside, "lies outside the rock and is dropped",
                "lie outside the rock and are dropped");
            say(r, idle[r].on_boundary, "runs along a free face only, which stays free",
                "run along a free face only, which stays free");
        }
    }

    void say(std::size_t row, std::size_t count, const std::string& one, const std::string& many) {
        if (count > 0)
            report_.warnings.push_back(std::to_string(count) + (count == 1 ? " trace" : " traces") + " of '" +
                                       report_.joints[row].name + "' " + (count == 1 ? one : many));
    }

    CutContext context_;
    std::vector<TraceLengths> trace_lengths_;
    std::vector<std::size_t> row_;
    std::vector<AxialSums> sums_;
    std::vector<double> across_;  ///< per row: length projected on the mean direction
    NetworkReport report_;
};

}  // namespace

NetworkReport measure_network(const NodedEdges& noded, const Subdivision& subdivision,
                              const FaceBlocks& faces, const SlopeModel& model,
                              const std::vector<Trace>& traces, const SourceTable& table, double rock_area) {
    return NetworkMeasure({noded, subdivision, faces, model, traces, table}).run(rock_area);
}

}  // namespace rockslope::blockgen
