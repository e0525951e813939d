#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "blockgen/sampling/set_sampler.hpp"

namespace rockslope::blockgen {

namespace {

double along(const Point& direction, const Point& p) {
    return direction.x * p.x + direction.y * p.y;
}

}  // namespace

Point mean_normal(const JointSet& set) {
    const double angle = set.orientation.mean_angle();
    return {-std::sin(angle), std::cos(angle)};
}

Point scanline_point(const SetSampler& sampler) {
    const std::optional<Point>& origin = sampler.set().origin;
    return origin ? sampler.bounds().nearest(*origin) : sampler.centre();
}

OffsetRange offset_range(const SetSampler& sampler, double max_deviation_tangent, double margin) {
    const JointSet& set = sampler.set();
    const Point across = mean_normal(set), base = scanline_point(sampler);
    OffsetRange reach{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    // A line at the angle delta to the mean direction through a corner at the distance h from the scanline
    // crosses the scanline h tan(delta) above or below the corner.
    for (const Point& p : sampler.bounds().expanded(margin).corners()) {
        const double shift =
            max_deviation_tangent * std::abs(across.y * (p.x - base.x) - across.x * (p.y - base.y));
        reach.low = std::min(reach.low, along(across, p) - shift);
        reach.high = std::max(reach.high, along(across, p) + shift);
    }
    reach.origin = set.origin ? along(across, *set.origin) : reach.low;
    return reach;
}

std::vector<SetLine> spaced_lines(SetSampler& sampler, double margin) {
    const JointSet& set = sampler.set();
    const RandomStream& draws = sampler.draws();
    const Point across = mean_normal(set);
    const OffsetRange reach = offset_range(sampler, set.orientation.max_deviation_tangent(), margin);
    const Bounds box = sampler.bounds().expanded(margin);
    const Point base = scanline_point(sampler);
    std::vector<SetLine> lines;
    const auto add = [&](std::int64_t number, double offset) {
        if (offset < reach.low) return;
        SetLine line;
        line.number = number;
        line.u = sampler.direction(number);
        const double shift = offset - along(across, base);
        line.middle = {base.x + shift * across.x, base.y + shift * across.y};
        const auto inside = box.clip(line.middle, line.u);
        if (!inside) return;
        std::tie(line.low, line.high) = *inside;
        lines.push_back(line);
    };
    // Without an origin, the first line is eight to nine mean spacings before the box, at a random phase. The
    // spacings are then stationary where the box begins. A line placed in the box at random, with spacings to
    // both sides, would give one line too many for widely scattered spacings (length-biased sampling).
    constexpr std::int64_t run_up = 9;
    const std::int64_t before = set.origin ? 0 : run_up;
    const double first = set.origin
                             ? reach.origin
                             : reach.low + (draws.draw(draw_phase, 0, 0) - static_cast<double>(run_up)) *
                                               set.spacing.truncated_mean();
    double offset = first;
    for (std::int64_t line = -before; offset <= reach.high; ++line) {
        sampler.count_draw();
        add(line, offset);
        offset += set.spacing.quantile(
            draws.draw(draw_spacing_forward, 0, static_cast<std::uint64_t>(line + before)));
    }
    if (!set.origin) return lines;
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

}  // namespace rockslope::blockgen
