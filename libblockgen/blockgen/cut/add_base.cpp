#include "blockgen/cut/add_base.hpp"

#include <algorithm>

#include "common/geometry/clip_line.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

namespace {

bool may_meet(const Bounds& a, const Bounds& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// The pieces of a segment outside a ring, in order along it.
std::vector<std::pair<Point, Point>> pieces_outside(const Point& a, const Point& b, const Ring& ring) {
    std::vector<std::pair<Point, Point>> pieces;
    Point from = a;
    for (const auto& [p, q] : clip_to_ring(a, b, ring)) {
        if (p != from) pieces.emplace_back(from, p);
        from = q;
    }
    if (from != b) pieces.emplace_back(from, b);
    return pieces;
}

/// Adds the pieces of a trace outside a ring.
void add_outside(const Trace& trace, const Ring& ring, const Bounds& box, std::vector<Trace>& result) {
    if (!may_meet(Bounds::of(trace.points), box)) {
        result.push_back(trace);
        return;
    }
    std::size_t first = result.size();
    for (std::size_t k = 0; k + 1 < trace.points.size(); ++k)
        for (const auto& [a, b] : pieces_outside(trace.points[k], trace.points[k + 1], ring)) {
            if (result.size() > first && result.back().points.back() == a)
                result.back().points.push_back(b);
            else
                result.push_back({trace.name, trace.joint_material, {a, b}, trace.draw});
        }
}

}  // namespace

SlopeWithBase add_base(const SlopeModel& model, const std::vector<Trace>& traces) {
    const BaseBlock& base = *model.base;
    SlopeWithBase result{model, {}};
    SlopeModel& slope = result.model;
    slope.base.reset();
    slope.further_outlines.push_back(base.outline);
    slope.regions.push_back({base.name, base.block_material, base.joint_material, base.outline, base.place});
    slope.unjointed_area = std::abs(twice_signed_area(base.outline)) / 2;
    BlockSelector selector;
    selector.at = base.inside;
    selector.prescribed = !base.is_fixed;
    selector.name = base.is_fixed ? "" : base.name;
    selector.place = base.place;
    slope.selectors.insert(slope.selectors.begin(), selector);

    const Bounds box = Bounds::of(base.outline);
    for (std::size_t t = 0; t < traces.size(); ++t) {
        add_outside(traces[t], base.outline, box, result.traces);
        if (t + 1 == model.traces.size()) slope.traces = result.traces;
    }
    result.traces.push_back({base.name, base.joint_material, base.contact});
    return result;
}

}  // namespace rockslope::blockgen
