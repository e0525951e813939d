#include "blockgen/sampling/expected_draws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/base/input_error.hpp"

namespace rockslope::blockgen {

namespace {

double area_of(const Bounds& box) {
    return (box.high.x - box.low.x) * (box.high.y - box.low.y);
}

/// Draws along one line of mean length `length`: the run-up of eight to nine cycles, then traces until the
/// line ends. Cycles longer than all of that end it at once, so they count as no longer.
double expected_draws_along_line(const JointSet& set, double length) {
    if (!set.trace_length) return 0;
    const double run_up = 8.5 * (set.trace_length->untruncated_mean() + set.gap->untruncated_mean());
    const double whole = length + run_up;
    return 1 + whole / (set.trace_length->truncated_mean(whole) + set.gap->truncated_mean(whole));
}

/// Lines at spacings over a width w. With spacings cut off at w their sum passes w by no more than another w,
/// so that by Wald's identity there are between w and 2 w over the mean of the cut-off spacings.
double expected_lines(const JointSet& set, double width) {
    return 2 + width / set.spacing.truncated_mean(width);
}

/// The same between where lines may meet the box, and from a distant origin to there.
double expected_lines(const SetSampler& sampler) {
    const OffsetRange reach = offset_range(sampler, sampler.set().orientation.max_deviation_tangent());
    return expected_lines(sampler.set(),
                          std::max(reach.high, reach.origin) - std::min(reach.low, reach.origin));
}

/// Most lines that meet the box cross the scanline between the box's two sides across the set.
double expected_parallel_draws(const SetSampler& sampler) {
    const OffsetRange reach = offset_range(sampler, 0);
    const double width = reach.high - reach.low;
    return expected_lines(sampler) +
           expected_lines(sampler.set(), width) *
               expected_draws_along_line(sampler.set(), area_of(sampler.bounds()) / width);
}

/// A line is drawn, and a piece for each joint that it meets and ends on. Lines meet a trace as often as
/// their spacing fits into the trace's width across the set.
double expected_cross_joint_draws(const SetSampler& sampler, const std::vector<Trace>& others) {
    const JointSet& set = sampler.set();
    const Point across = mean_normal(set);
    const OffsetRange reach = offset_range(sampler, 0);
    double met = 0;
    for (const Trace& trace : others)
        for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
            const Point &a = trace.points[k], &b = trace.points[k + 1];
            const Point u{b.x - a.x, b.y - a.y};
            const auto inside = sampler.bounds().clip(a, u);
            if (!inside) continue;
            const double part = std::min(inside->second, 1.0) - std::max(inside->first, 0.0);
            met += std::max(part, 0.0) * std::abs(across.x * u.x + across.y * u.y);
        }
    return 2 * expected_lines(sampler) +
           set.termination * met / set.spacing.truncated_mean(reach.high - reach.low);
}

/// The part of a joint's length that a line across the mean direction sees, in the mean: of a few draws.
double mean_cosine(const SetSampler& sampler) {
    constexpr int few = 64;
    const Point across = mean_normal(sampler.set());
    double sum = 0;
    for (int k = 0; k < few; ++k) {
        const Point u = sampler.direction(k);
        sum += std::abs(u.y * across.x - u.x * across.y);
    }
    return std::max(sum / few, 1.0 / few);
}

/// The length, or number, that the stop rule waits for.
double target_of(const SetSampler& sampler, double rock_area) {
    const StopRule& stop = sampler.set().stop;
    if (stop.measure == StopRule::Measure::count) return stop.target;
    const double share = stop.measure == StopRule::Measure::p10 ? mean_cosine(sampler) : 1;
    return stop.target * rock_area / share;
}

/// A trace with its middle anywhere in the window lies in the rock with the share of the rock's area in it.
double expected_baecher_draws(const SetSampler& sampler, double rock_area) {
    const JointSet& set = sampler.set();
    const bool is_counted =
        set.stop.measure == StopRule::Measure::count || set.stop.measure == StopRule::Measure::p20;
    const double each = is_counted ? 1 : set.trace_length->truncated_mean();
    return target_of(sampler, rock_area) / each * area_of(baecher_window(sampler)) / rock_area;
}

/// A line at any distance up to the radius has the chord area / 2 radius in the rock, in the mean. Of a count
/// of lines those that miss the rock are left out, which only lowers the sum.
double expected_veneziano_draws(const SetSampler& sampler, double rock_area) {
    const JointSet& set = sampler.set();
    const double width = 2 * sampler.radius();
    double lines = set.stop.target;
    if (set.stop.measure != StopRule::Measure::count) {
        double open = 1;
        if (set.trace_length) {
            const double length = set.trace_length->truncated_mean();
            open = length / (length + set.gap->truncated_mean());
        }
        lines = target_of(sampler, rock_area) * width / (rock_area * open);
    }
    return lines * (1 + expected_draws_along_line(set, area_of(sampler.bounds()) / width));
}

}  // namespace

double expected_draws(const SetSampler& sampler, const RockDomain* rock, const std::vector<Trace>& others) {
    switch (sampler.set().kind) {
        case SetKind::parallel:
            return expected_parallel_draws(sampler);
        case SetKind::cross_jointed:
            return expected_cross_joint_draws(sampler, others);
        case SetKind::baecher:
            return expected_baecher_draws(sampler, rock->area());
        case SetKind::veneziano:
            return expected_veneziano_draws(sampler, rock->area());
        case SetKind::voronoi:
            return area_of(voronoi_window(sampler, rock->area())) * sampler.set().stop.target / rock->area();
    }
    return 0;
}

void check_expected_draws(const SetSampler& sampler, const RockDomain* rock,
                          const std::vector<Trace>& others) {
    const double expected = expected_draws(sampler, rock, others);
    if (expected <= static_cast<double>(sampler.max_draws())) return;
    char count[32];
    std::snprintf(count, sizeof count, "%.3g", expected);
    sampler.fail_too_many(std::string("about ") + count);
}

}  // namespace rockslope::blockgen
