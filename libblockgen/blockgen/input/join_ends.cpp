#include "blockgen/input/join_ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <tuple>

#include "blockgen/input/domain.hpp"
#include "blockgen/input/near_segments.hpp"
#include "blockgen/input/read_shapes.hpp"
#include "common/base/text.hpp"
#include "common/geometry/orientation.hpp"
#include "common/geometry/point_text.hpp"

namespace rockslope::blockgen {

namespace {

constexpr std::int32_t outline_owner = -1, nobody = -2;
constexpr double infinity = std::numeric_limits<double>::infinity();

double distance(const Point& p, const Point& q) {
    return std::hypot(p.x - q.x, p.y - q.y);
}

/// An end of a trace.
struct TraceEnd {
    std::int32_t trace = 0;
    bool last = false;
    Point at;
    bool is_fixed = false;  ///< it lies on something, or others were moved to it
    bool is_done = false;
};

/// What an end is near to.
struct Neighbour {
    NearSegment segment;
    Point at;
    double distance = infinity;

    bool exists() const { return distance < infinity; }
    void take_nearer(const NearSegment& other, const Point& q, double d) {
        if (std::tuple(d, q.x, q.y) < std::tuple(distance, at.x, at.y)) *this = {other, q, d};
    }
};

void add_ring(std::vector<NearSegment>& segments, const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k)
        segments.push_back({ring[k], ring[(k + 1) % ring.size()], outline_owner, 0});
}

/// The segments of all traces, owned by their numbers, and of all outlines.
std::vector<NearSegment> segments_of(const SlopeModel& model) {
    std::vector<NearSegment> segments;
    for (std::size_t t = 0; t < model.traces.size(); ++t) {
        const std::vector<Point>& points = model.traces[t].points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            segments.push_back(
                {points[k], points[k + 1], static_cast<std::int32_t>(t), static_cast<std::int32_t>(k)});
    }
    add_ring(segments, model.outline);
    for (const Ring& ring : model.further_outlines) add_ring(segments, ring);
    for (const Ring& ring : model.holes) add_ring(segments, ring);
    for (const Region& region : model.regions) add_ring(segments, region.polygon);
    for (const Excavation& excavation : model.excavations) add_ring(segments, excavation.outline);
    for (const Tunnel& tunnel : model.tunnels) add_ring(segments, tunnel.outline);
    return segments;
}

class EndJoiner {
  public:
    EndJoiner(double snap, SlopeModel& model) : snap_(snap), model_(model) {}

    void run() {
        const Bounds box = domain_bounds(model_);
        const double length = length_in(box);
        if (!(length > 0)) return;
        density_ = length / ((box.high.x - box.low.x) * (box.high.y - box.low.y));
        if (snap_ > 0) join();
        count_near_misses(box);
    }

  private:
    /// The length of all traces within a box.
    double length_in(const Bounds& box) const {
        double length = 0;
        for (const Trace& trace : model_.traces)
            for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
                const Point &a = trace.points[k], &b = trace.points[k + 1];
                const auto inside = box.clip(a, {b.x - a.x, b.y - a.y});
                if (!inside) continue;
                const double share = std::min(inside->second, 1.0) - std::max(inside->first, 0.0);
                length += std::max(share, 0.0) * distance(a, b);
            }
        return length;
    }

    /// The ends of all traces.
    std::vector<TraceEnd> all_ends() const {
        std::vector<TraceEnd> ends;
        ends.reserve(2 * model_.traces.size());
        for (std::size_t t = 0; t < model_.traces.size(); ++t)
            for (const bool last : {false, true})
                ends.push_back({static_cast<std::int32_t>(t), last,
                                point_of({static_cast<std::int32_t>(t), last}), false, false});
        return ends;
    }

    static bool is_left_of(const TraceEnd& e, const TraceEnd& f) {
        return std::pair(e.at.x, e.at.y) < std::pair(f.at.x, f.at.y);
    }

    struct EndOfTrace {
        std::int32_t trace;
        bool last;
    };
    const Point& point_of(EndOfTrace end) const {
        const std::vector<Point>& points = model_.traces[end.trace].points;
        return end.last ? points.back() : points.front();
    }

    /// Whether the last piece of the end's own trace meets a segment.
    bool meets(const TraceEnd& end, const NearSegment& segment) const {
        const std::vector<Point>& points = model_.traces[end.trace].points;
        const Point& inner = end.last ? points[points.size() - 2] : points[1];
        return segment_relation(inner, end.at, segment.a, segment.b) != SegmentRelation::apart;
    }

    /// The nearest segment of another trace or of an outline; `is_joined` tells that the end lies on one
    /// already.
    Neighbour nearest(const TraceEnd& end, const NearSegments& segments, bool& is_joined) const {
        Neighbour found;
        is_joined = false;
        segments.visit_near(end.at, end.trace, [&](const NearSegment& segment, const Point& q, double d) {
            is_joined = is_joined || d <= model_.grid;
            if (d > model_.grid && !meets(end, segment)) found.take_nearer(segment, q, d);
        });
        return found;
    }

    void join() {
        ends_ = all_ends();
        std::stable_sort(ends_.begin(), ends_.end(), is_left_of);
        {
            const NearSegments segments(segments_of(model_), snap_);
            for (TraceEnd& end : ends_) {
                nearest(end, segments, end.is_fixed);
                end.is_done = end.is_fixed;
            }
            join_to_ends(segments);
        }
        join_to_segments(NearSegments(segments_of(model_), snap_));
    }

    /// Moves ends to others near them. The leftmost of some free ones stays.
    void join_to_ends(const NearSegments& segments) {
        std::vector<NearSegment> points;
        for (std::size_t k = 0; k < ends_.size(); ++k)
            points.push_back({ends_[k].at, ends_[k].at, static_cast<std::int32_t>(k), 0});
        const NearSegments near(points, snap_);
        for (TraceEnd& end : ends_) {
            if (end.is_done) continue;
            Neighbour other;
            near.visit_near(end.at, nobody, [&](const NearSegment& point, const Point& q, double d) {
                const TraceEnd& candidate = ends_[point.owner];
                if (may_join(end, candidate)) other.take_nearer(point, q, d);
            });
            if (!other.exists()) continue;
            bool is_joined = false;
            const Neighbour segment = nearest(end, segments, is_joined);
            // A piece of joint much nearer than any end is what the end was drawn to.
            if (segment.distance < 0.5 * other.distance) continue;
            TraceEnd& target = ends_[other.segment.owner];
            if (target.is_fixed) {
                move(end, target.at, target.trace);
                continue;
            }
            end.is_fixed = end.is_done = true;
            near.visit_near(end.at, nobody, [&](const NearSegment& point, const Point&, double) {
                TraceEnd& free = ends_[point.owner];
                if (!free.is_done && may_join(end, free)) move(free, end.at, end.trace);
            });
        }
    }

    /// Whether an end may be joined to another one: fixed, or still free. The two ends of a trace may close
    /// it when it is a chain of three pieces or more.
    bool may_join(const TraceEnd& end, const TraceEnd& other) const {
        if (&end == &other || (other.is_done && !other.is_fixed)) return false;
        return end.trace != other.trace || model_.traces[end.trace].points.size() > 3;
    }

    void move(TraceEnd& end, const Point& to, std::int32_t other) {
        std::vector<Point>& points = model_.traces[end.trace].points;
        (end.last ? points.back() : points.front()) = to;
        add(model_.trace_ends.joined, end, to, distance(end.at, to), other);
        end.is_done = true;
    }

    void add(std::vector<NearEnd>& list, const TraceEnd& end, const Point& at, double gap,
             std::int32_t other) const {
        list.push_back({at, gap, model_.traces[end.trace].name,
                        other == outline_owner ? "outline" : model_.traces[other].name});
    }

    /// A vertex that a trace gets where an end comes to lie on it.
    struct NewVertex {
        std::int32_t trace, segment;
        double along;
        Point at;
    };

    /// Moves the ends that are left to the nearest points of traces and outlines.
    void join_to_segments(const NearSegments& segments) {
        std::vector<NewVertex> vertices;
        for (TraceEnd& end : ends_) {
            if (end.is_done) continue;
            bool is_joined = false;
            const Neighbour other = nearest(end, segments, is_joined);
            if (is_joined || !other.exists()) continue;
            move(end, other.at, other.segment.owner);
            if (other.segment.owner != outline_owner)
                vertices.push_back({other.segment.owner, other.segment.number,
                                    distance(other.segment.a, other.at), other.at});
        }
        insert(std::move(vertices));
    }

    void insert(std::vector<NewVertex> vertices) {
        // From the back of each trace, so that numbers of segments stay true.
        std::sort(vertices.begin(), vertices.end(), [](const NewVertex& v, const NewVertex& w) {
            return std::tuple(v.trace, -v.segment, -v.along) < std::tuple(w.trace, -w.segment, -w.along);
        });
        for (const NewVertex& vertex : vertices) {
            std::vector<Point>& points = model_.traces[vertex.trace].points;
            const auto before = points.begin() + vertex.segment;
            if (*before == vertex.at || *(before + 1) == vertex.at) continue;
            points.insert(before + 1, vertex.at);
        }
    }

    /// Ends that stop short of something by less than a twentieth of the mean distance of the traces.
    void count_near_misses(const Bounds& box) {
        const double reach = 1 / (20 * density_);
        const NearSegments segments(segments_of(model_), reach);
        std::vector<std::pair<TraceEnd, Neighbour>> short_ends;
        std::size_t free_ends = 0;
        const std::vector<TraceEnd> ends = all_ends();
        const auto place_of = [&](std::size_t k) { return ends[k].at; };
        segments.visit_in_turn(ends.size(), place_of, [&](std::size_t k) {
            const TraceEnd& end = ends[k];
            if (box.nearest(end.at) != end.at) return;
            bool is_joined = false;
            const Neighbour other = nearest(end, segments, is_joined);
            if (is_joined) return;
            ++free_ends;
            if (other.exists()) short_ends.emplace_back(end, other);
        });
        std::stable_sort(short_ends.begin(), short_ends.end(),
                         [](const auto& e, const auto& f) { return is_left_of(e.first, f.first); });
        TraceEnds& report = model_.trace_ends;
        report.suggested_snap = suggested_snap(short_ends, free_ends, reach);
        // Where nothing is suggested, a tenth of that reach: one free end in a hundred lies so near by
        // chance.
        report.reach = report.suggested_snap > 0 ? report.suggested_snap : reach / 10;
        for (const auto& [end, other] : short_ends)
            if (other.distance <= report.reach)
                add(report.near_misses, end, end.at, other.distance, other.segment.owner);
        if (report.suggested_snap > 0) add_note(free_ends);
    }

    /// The number of ends that lie within a distance of a trace by chance, where traces of this density run
    /// anywhere: 2 rho r of them.
    double by_chance(std::size_t free_ends, double r) const {
        return 2 * density_ * r * static_cast<double>(free_ends);
    }

    /// The value of 1, 2, 5, 10, ... below which most more ends stop short than twice those of chance, and
    /// those above it for as long as the next one adds more than chance does. 0 when there are fewer than
    /// three, or than one in a hundred.
    double suggested_snap(const std::vector<std::pair<TraceEnd, Neighbour>>& short_ends,
                          std::size_t free_ends, double reach) const {
        std::vector<double> gaps;
        for (const auto& [end, other] : short_ends) gaps.push_back(other.distance);
        std::sort(gaps.begin(), gaps.end());
        std::vector<double> candidates;
        for (int decade = -9; decade < 9; ++decade)
            for (const int digit : {1, 2, 5})
                candidates.push_back(*parse_number(std::to_string(digit) + "e" + std::to_string(decade)));
        std::erase_if(candidates, [&](double r) { return r > reach; });
        const auto excess = [&](double r, double weight) {
            const auto within = std::upper_bound(gaps.begin(), gaps.end(), r) - gaps.begin();
            return static_cast<double>(within) - weight * by_chance(free_ends, r);
        };
        const auto best = std::max_element(candidates.begin(), candidates.end(),
                                           [&](double r, double s) { return excess(r, 2) < excess(s, 2); });
        if (best == candidates.end() ||
            excess(*best, 2) <= std::max(2.5, 0.01 * static_cast<double>(free_ends)))
            return 0;
        auto widest = best;
        while (widest + 1 != candidates.end() && excess(*(widest + 1), 1) > excess(*widest, 1)) ++widest;
        return *widest;
    }

    void add_note(std::size_t free_ends) {
        const std::vector<NearEnd>& misses = model_.trace_ends.near_misses;
        double largest = 0;
        for (const NearEnd& end : misses) largest = std::max(largest, end.gap);
        char text[256];
        std::snprintf(text, sizeof text,
                      "%zu ends of traces stop short of a joint or an outline by up to %.2g m, where chance "
                      "explains %.1f: snap = %g in [domain] joins them; the first is at ",
                      misses.size(), largest, by_chance(free_ends, model_.trace_ends.suggested_snap),
                      model_.trace_ends.suggested_snap);
        model_.notes.push_back(text + text_of(misses.front().at));
    }

    double snap_;
    SlopeModel& model_;
    double density_ = 0;  ///< 1/m, length of the traces per area
    std::vector<TraceEnd> ends_;
};

}  // namespace

void join_ends(double snap, SlopeModel& model) {
    EndJoiner(snap, model).run();
}

}  // namespace rockslope::blockgen
