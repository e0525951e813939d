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

/// Expected draws along one line of mean length `length`: a run-up of eight to nine cycles of trace and gap,
/// then the line itself. Lengths beyond their sum are capped, because one such draw ends the line.
double expected_draws_along_line(const JointSet& set, double length) {
    if (!set.trace_length) return 0;
    const double run_up = 8.5 * (set.trace_length->untruncated_mean() + set.gap->untruncated_mean());
    const double total = length + run_up;
    return 1 + total / (set.trace_length->truncated_mean(total) + set.gap->truncated_mean(total));
}

/// Expected number of lines over a width w. With spacings capped at w, their sum exceeds w by at most w; by
/// Wald's identity the number is between w and 2 w over the mean capped spacing.
double expected_lines(const JointSet& set, double width) {
    return 2 + width / set.spacing.truncated_mean(width);
}

/// Expected number of lines over the range in which they may meet the box, extended to a distant origin.
double expected_lines(const SetSampler& sampler) {
    const OffsetRange reach = offset_range(sampler, sampler.set().orientation.max_deviation_tangent());
    return expected_lines(sampler.set(),
                          std::max(reach.high, reach.origin) - std::min(reach.low, reach.origin));
}

/// Expected draws of a parallel set. Most lines that meet the box cross the scanline within the width of the
/// box perpendicular to the set.
double expected_parallel_draws(const SetSampler& sampler) {
    const OffsetRange reach = offset_range(sampler, 0);
    const double width = reach.high - reach.low;
    return expected_lines(sampler) +
           expected_lines(sampler.set(), width) *
               expected_draws_along_line(sampler.set(), area_of(sampler.bounds()) / width);
}

/// Expected draws of a cross-jointed set: one per line, and one per piece between joints at which the line
/// ends. The number of lines that meet a trace is the trace's width perpendicular to the set over the
/// spacing.
double expected_cross_joint_draws(const SetSampler& sampler, const std::vector<Trace>& others) {
    const JointSet& set = sampler.set();
    const Point across = mean_normal(set);
    const OffsetRange reach = offset_range(sampler, 0);
    double crossed_width = 0;
    for (const Trace& trace : others)
        for (std::size_t k = 0; k + 1 < trace.points.size(); ++k) {
            const Point &a = trace.points[k], &b = trace.points[k + 1];
            const Point u{b.x - a.x, b.y - a.y};
            const auto inside = sampler.bounds().clip(a, u);
            if (!inside) continue;
            const double part = std::min(inside->second, 1.0) - std::max(inside->first, 0.0);
            crossed_width += std::max(part, 0.0) * std::abs(across.x * u.x + across.y * u.y);
        }
    return 2 * expected_lines(sampler) +
           set.termination * crossed_width / set.spacing.truncated_mean(reach.high - reach.low);
}

/// Mean cosine of the angle between a joint and the mean direction, from a sample of directions.
double mean_cosine(const SetSampler& sampler) {
    constexpr int samples = 64;
    const Point across = mean_normal(sampler.set());
    double sum = 0;
    for (int k = 0; k < samples; ++k) {
        const Point u = sampler.direction(k);
        sum += std::abs(u.y * across.x - u.x * across.y);
    }
    return std::max(sum / samples, 1.0 / samples);
}

/// The total trace length in the rock, m, or the number of traces at which the stop rule is met.
double target_of(const SetSampler& sampler, double rock_area) {
    const StopRule& stop = sampler.set().stop;
    if (stop.measure == StopRule::Measure::count) return stop.target;
    const double cosine = stop.measure == StopRule::Measure::p10 ? mean_cosine(sampler) : 1;
    return stop.target * rock_area / cosine;
}

/// Expected draws of a Baecher set. A trace has its midpoint in the rock with the probability rock area over
/// window area.
double expected_baecher_draws(const SetSampler& sampler, double rock_area) {
    const JointSet& set = sampler.set();
    const bool is_counted =
        set.stop.measure == StopRule::Measure::count || set.stop.measure == StopRule::Measure::p20;
    const double each = is_counted ? 1 : set.trace_length->truncated_mean();
    return target_of(sampler, rock_area) / each * area_of(baecher_window(sampler)) / rock_area;
}

/// Expected draws of a Veneziano set. A random line has the mean length rock area / (2 radius) in the rock.
/// For a target number of lines, those that miss the rock are neglected, so the result is a lower bound.
double expected_veneziano_draws(const SetSampler& sampler, double rock_area) {
    const JointSet& set = sampler.set();
    const double width = 2 * sampler.radius();
    double lines = set.stop.target;
    if (set.stop.measure != StopRule::Measure::count) {
        double persistence = 1;
        if (set.trace_length) {
            const double length = set.trace_length->truncated_mean();
            persistence = length / (length + set.gap->truncated_mean());
        }
        lines = target_of(sampler, rock_area) * width / (rock_area * persistence);
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
