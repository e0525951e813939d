#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "blockgen/sampling/set_sampler.hpp"

namespace blockgen {

namespace {

struct Reach {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

double along(const Point& direction, const Point& p) {
    return direction.x * p.x + direction.y * p.y;
}

/// The distances across the set within which lines may meet the box.
Reach reach_of(const SetSampler& sampler, const Point& across) {
    Reach reach;
    // Lines that are not parallel to the mean direction may enter the box from beyond its own width across
    // the set.
    if (sampler.set().orientation.is_spread()) {
        const double middle = along(across, sampler.centre());
        return {middle - sampler.radius(), middle + sampler.radius()};
    }
    for (const Point& p : sampler.bounds().corners()) {
        reach.low = std::min(reach.low, along(across, p));
        reach.high = std::max(reach.high, along(across, p));
    }
    return reach;
}

}  // namespace

std::vector<SetLine> spaced_lines(SetSampler& sampler) {
    const JointSet& set = sampler.set();
    const DrawStream& draws = sampler.draws();
    const double mean_angle = set.orientation.mean_angle();
    const Point across{-std::sin(mean_angle), std::cos(mean_angle)};
    const Reach reach = reach_of(sampler, across);
    std::vector<SetLine> lines;
    const auto add = [&](std::int64_t number, double offset) {
        if (offset < reach.low) return;
        SetLine line;
        line.number = number;
        line.u = sampler.direction(number);
        const double shift = offset - along(across, sampler.centre());
        line.middle = {sampler.centre().x + shift * across.x, sampler.centre().y + shift * across.y};
        const auto inside = sampler.bounds().clip(line.middle, line.u);
        if (!inside) return;
        std::tie(line.low, line.high) = *inside;
        lines.push_back(line);
    };
    const double first = set.origin ? along(across, *set.origin)
                                    : reach.low + draws.draw(draw_phase, 0, 0) *
                                                      set.spacing.quantile(draws.draw(draw_phase, 0, 1));
    double offset = first;
    for (std::int64_t line = 0; offset <= reach.high; ++line) {
        sampler.count_draw();
        add(line, offset);
        offset += set.spacing.quantile(draws.draw(draw_spacing_forward, 0, static_cast<std::uint64_t>(line)));
    }
    offset = first;
    for (std::int64_t line = -1;; --line) {
        sampler.count_draw();
        offset -=
            set.spacing.quantile(draws.draw(draw_spacing_backward, 0, static_cast<std::uint64_t>(-line)));
        if (offset < reach.low) break;
        add(line, offset);
    }
    return lines;
}

std::vector<Trace> sample_parallel(SetSampler& sampler) {
    std::vector<Trace> traces;
    for (const SetLine& line : spaced_lines(sampler))
        sampler.add_traces(line.number, line.middle, line.u, line.low, line.high, traces);
    return traces;
}

}  // namespace blockgen
