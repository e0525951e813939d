#include "peer/joint_families.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blockgen/sampling/sample_joints.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::peer {

using namespace blockgen;

namespace {

constexpr double size = 100;

JointSet set_at(double degrees, const Distribution& spacing) {
    JointSet set;
    set.name = set.joint_material = "set at " + std::to_string(static_cast<int>(degrees));
    set.orientation.angle = constant_value(degrees * std::numbers::pi / 180);
    set.spacing = spacing;
    return set;
}

}  // namespace

std::string name_of(Family family) {
    if (family == Family::two_sets) return "two sets";
    return family == Family::three_sets ? "three sets" : "ending in rock";
}

SlopeModel family_slope(Family family, double blocks) {
    SlopeModel model;
    model.seed = 1;
    model.outline = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    model.block_material = "rock";
    const double s = size / std::sqrt(blocks);
    if (family == Family::two_sets)
        model.joint_sets = {set_at(20, constant_value(s)), set_at(110, constant_value(s))};
    // Two sets at 60 degrees have sin 60 / s^2 crossings per area, so three sets have 2.6 / s^2.
    if (family == Family::three_sets)
        for (const double angle : {0.5, 60.5, 120.5}) {
            const double mean = s * std::sqrt(3 * std::sin(std::numbers::pi / 3));
            model.joint_sets.push_back(set_at(angle, {Law::exponential, mean, 0, mean / 100}));
        }
    if (family == Family::ending_in_rock)
        for (const double angle : {5.0, 65.0, 125.0}) {
            JointSet set = set_at(angle, constant_value(1.21 * s));
            set.trace_length = Distribution{Law::exponential, 8 * set.spacing.mean};
            set.gap = Distribution{Law::exponential, 2 * set.spacing.mean};
            model.joint_sets.push_back(set);
        }
    return model;
}

std::vector<Trace> traces_across_boundary(const SlopeModel& model) {
    std::vector<Trace> traces = all_traces(model);
    const Bounds bounds = Bounds::of(model.outline);
    const auto is_on_boundary = [&](const Point& p) {
        return std::min({p.x - bounds.low.x, bounds.high.x - p.x, p.y - bounds.low.y, bounds.high.y - p.y}) <
               1e-9;
    };
    for (Trace& trace : traces) {
        Point &a = trace.points[0], &b = trace.points[1];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const Point u{(b.x - a.x) / length, (b.y - a.y) / length};
        if (is_on_boundary(a)) a = {a.x - u.x, a.y - u.y};
        if (is_on_boundary(b)) b = {b.x + u.x, b.y + u.y};
    }
    return traces;
}

}  // namespace rockslope::peer
