#include "blockgen/report/joint_balance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "blockgen/faces/cut_context.hpp"
#include "blockgen/input/domain.hpp"
#include "blockgen/input/trace_length.hpp"
#include "blockgen/sampling/rock_domain.hpp"

namespace rockslope::blockgen {

namespace {

bool is_in_rock(const SlopeModel& model, const Point& p) {
    if (!is_in_outlines(model, p)) return false;
    for (const Ring& hole : model.holes)
        if (side_of_ring(hole, p) > 0) return false;
    for (const Tunnel& tunnel : model.tunnels)
        if (side_of_ring(tunnel.outline, p) > 0) return false;
    return true;
}

/// Length-weighted sums for the mean direction of axial data; angles are doubled, because a joint's direction
/// has no sign.
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

/// A row of the balance: all traces of one name.
using RowIndex = Index<struct BalanceRowKind>;
template <class T>
using PerRow = IndexedVector<RowIndex, T>;

/// Balance of the length of one trace, m.
struct TraceLengths {
    double retained = 0, pruned = 0, repeated = 0, on_boundary = 0, outside = 0;
    std::size_t edges = 0;
    double in_rock() const { return retained + pruned + repeated; }
    double inside_box() const { return in_rock() + on_boundary + outside; }
};

class NetworkMeasure {
  public:
    explicit NetworkMeasure(const CutContext& context)
        : context_(context), trace_lengths_(context.traces.size()) {
        assign_rows();
    }

    NetworkReport run(double rock_area) {
        add_edges();
        for (const JointTraceIndex t : trace_lengths_.indices()) add_trace(t);
        for (const RowIndex r : sums_.indices()) {
            JointBalance& b = report_.joints[r];
            const JointSet* set = set_of(b.name);
            const bool is_local = set != nullptr && !set->region.empty();
            const double area = is_local ? RockDomain(context_.model, set->region).area() : rock_area;
            b.p10 = projected_length_[r] / area;
            b.p20 /= area;
            b.p21 = (b.retained + b.pruned) / area;
            if (set != nullptr) set_targets(*set, b);
            b.weighted_by_section = set != nullptr && set->orientation.weighted_by_section;
        }
        return std::move(report_);
    }

  private:
    void assign_rows() {
        std::unordered_map<std::string, RowIndex> row_of_name;
        for (const Trace& trace : context_.traces) {
            const auto [found, is_new] = row_of_name.emplace(trace.name, report_.joints.size());
            if (is_new) report_.joints.push_back({trace.name});
            row_.push_back(found->second);
        }
        sums_.resize(report_.joints.size());
        projected_length_.resize(report_.joints.size());
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
            const double length = set.trace_length->truncated_mean();
            b.p10_target *= length / (length + set.gap->truncated_mean());
        }
        if (!set.orientation.has_scatter()) b.p21_target = b.p10_target;
    }

    /// The direction onto which lengths are projected for P10, rad: the nominal mean direction of a set, or
    /// the mean direction of given traces and of Voronoi edges.
    double mean_direction(RowIndex row) const {
        const JointSet* set = set_of(report_.joints[row].name);
        return set != nullptr && set->kind != SetKind::voronoi ? set->orientation.mean_angle()
                                                               : sums_[row].mean_direction();
    }

    bool is_rock(HalfEdgeIndex half_edge) const {
        return context_.block_of(half_edge) != FaceBlocks::outside;
    }
    Point vector_of(EdgeIndex e) const {
        const GridPoint& a = context_.noded.vertices[context_.noded.edges[e].first];
        const GridPoint& b = context_.noded.vertices[context_.noded.edges[e].second];
        return {context_.noded.frame.step * static_cast<double>(b.x - a.x),
                context_.noded.frame.step * static_cast<double>(b.y - a.y)};
    }

    /// @param visit called with each joint along the edge, and whether it is the first of them.
    template <class Visit>
    void for_each_joint_of(EdgeIndex edge, const Visit& visit) const {
        SourceIndex last = SourceIndex::none();
        for (const EdgeSource& s : context_.noded.sources_of(edge)) {  // sorted by source
            if (!context_.table.is_joint(s.source) || s.source == last) continue;
            visit(context_.table.trace_of(s.source), !last.exists());
            last = s.source;
        }
    }

    void add_edges() {
        for (const EdgeIndex e : context_.noded.edges.indices())
            for_each_joint_of(e, [&](JointTraceIndex t, bool is_first) { add_edge(e, t, is_first); });
        PerRow<Point> mean;
        for (const RowIndex r : sums_.indices()) {
            const double angle = mean_direction(r);
            mean.push_back({std::cos(angle), std::sin(angle)});
        }
        for (const EdgeIndex e : context_.noded.edges.indices())
            for_each_joint_of(e, [&](JointTraceIndex t, bool is_first) {
                if (!is_first || !is_rock(forward_half(e)) || !is_rock(backward_half(e))) return;
                const Point v = vector_of(e), u = mean[row_[t]];
                projected_length_[row_[t]] += std::abs(v.x * u.x + v.y * u.y);
            });
    }

    void add_edge(EdgeIndex e, JointTraceIndex t, bool is_first) {
        const Point v = vector_of(e);
        const double length = std::hypot(v.x, v.y);
        const bool left = is_rock(forward_half(e)), right = is_rock(backward_half(e));
        TraceLengths& lengths = trace_lengths_[t];
        ++lengths.edges;
        if (left != right)
            lengths.on_boundary += length;
        else if (!left)
            lengths.outside += length;
        else if (!is_first)
            lengths.repeated += length;
        else
            (context_.block_of(forward_half(e)) == context_.block_of(backward_half(e)) ? lengths.pruned
                                                                                       : lengths.retained) +=
                length;
        if (!left || !right || !is_first) return;
        sums_[row_[t]].add(v.x, v.y);
        auto& classes = report_.joints[row_[t]].length_by_direction;
        // Edges run from left to right, straight up ones upwards.
        const double turn = std::atan2(v.y, v.x) / std::numbers::pi + 0.5;
        classes[static_cast<std::size_t>(turn * static_cast<double>(classes.size())) % classes.size()] +=
            length;
    }

    void add_trace(JointTraceIndex t) {
        TraceLengths& lengths = trace_lengths_[t];
        JointBalance& b = report_.joints[row_[t]];
        const double input = length_of(context_.traces[t]);
        // Snapping may lengthen each piece by the displacement of its two ends. A trace that overlaps itself
        // counts once, so its noded length may be smaller.
        const double tolerance = 2 * context_.noded.largest_snap *
                                     static_cast<double>(lengths.edges + context_.traces[t].points.size()) +
                                 1e-9 * input;
        if (lengths.inside_box() > input + tolerance)
            throw std::logic_error("joint '" + context_.traces[t].name + "' is " +
                                   std::to_string(lengths.inside_box()) + " m long after noding, expected " +
                                   std::to_string(input) + " m");
        ++b.traces;
        b.input += input;
        b.retained += lengths.retained;
        b.pruned += lengths.pruned;
        b.repeated += lengths.repeated;
        b.on_boundary += lengths.on_boundary;
        // This includes the length clipped at the domain's box.
        b.outside += std::max(lengths.outside, input - lengths.in_rock() - lengths.on_boundary);
        const bool is_new = lengths.repeated == 0 || lengths.retained + lengths.pruned > 0;
        b.p20 += is_new && is_in_rock(context_.model, middle_of(context_.traces[t]));
    }

    CutContext context_;
    PerJointTrace<TraceLengths> trace_lengths_;
    PerJointTrace<RowIndex> row_;
    PerRow<AxialSums> sums_;
    PerRow<double> projected_length_;  ///< length projected onto the mean direction, m
    NetworkReport report_;
};

}  // namespace

NetworkReport measure_network(const CutContext& cut, double rock_area) {
    return NetworkMeasure(cut).run(rock_area);
}

double volumetric_joint_count(const std::vector<JointBalance>& joints) {
    double sum = 0;
    for (const JointBalance& b : joints) sum += b.p10;
    return sum;
}

}  // namespace rockslope::blockgen
