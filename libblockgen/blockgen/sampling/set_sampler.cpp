#include "blockgen/sampling/set_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "blockgen/input/domain.hpp"

namespace rockslope::blockgen {

namespace {

Bounds bounds_of(const JointSet& set, const SlopeModel& model) {
    for (const Region& region : model.regions)
        if (region.name == set.region) return Bounds::of(region.polygon);
    return domain_bounds(model);
}

}  // namespace

SetSampler::SetSampler(const JointSet& set, const SlopeModel& model, const DrawLimit& limit)
    : set_(set), draws_(model.seed, set.name), bounds_(bounds_of(set, model)), limit_(limit) {
    centre_ = {(bounds_.low.x + bounds_.high.x) / 2, (bounds_.low.y + bounds_.high.y) / 2};
    radius_ = std::hypot(bounds_.high.x - bounds_.low.x, bounds_.high.y - bounds_.low.y) / 2;
}

Pole SetSampler::plane(std::int64_t line) const {
    const Orientation& orientation = set_.orientation;
    const auto number = [&](std::uint64_t k) { return draws_.draw(draw_direction, line, k); };
    Pole pole = orientation.draw_pole(number(0), number(1));
    if (!orientation.weighted_by_section) return pole;
    // Planes are drawn until the section meets one. The limit is reached only by sets parallel to it.
    constexpr std::uint64_t most_planes = 100'000;
    for (std::uint64_t k = 1; k < most_planes && number(3 * k - 1) > section_chance(pole); ++k)
        pole = orientation.draw_pole(number(3 * k), number(3 * k + 1));
    return pole;
}

Point SetSampler::direction(std::int64_t line) const {
    const Orientation& orientation = set_.orientation;
    const double angle =
        orientation.weighted_by_section
            ? trace_angle(plane(line))
            : orientation.draw(draws_.draw(draw_direction, line, 0), draws_.draw(draw_direction, line, 1));
    return {std::cos(angle), std::sin(angle)};
}

Trace SetSampler::trace(std::optional<std::int64_t> line, const Point& a, const Point& b) const {
    return {set_.name, set_.joint_material, {a, b}, line};
}

void SetSampler::add_traces(std::int64_t line, const Point& middle, const Point& u, double low, double high,
                            std::vector<Trace>& traces) {
    const auto add = [&](double from, double to) {
        if (from < to && from < high && to > low)
            traces.push_back(trace(line, {middle.x + from * u.x, middle.y + from * u.y},
                                   {middle.x + to * u.x, middle.y + to * u.y}));
    };
    if (!set_.trace_length) return add(low, high);
    const double cycle = set_.trace_length->untruncated_mean() + set_.gap->untruncated_mean();
    double t = low - (8 + draws_.draw(draw_start, line, 0)) * cycle;
    for (std::uint64_t k = 0; t < high; ++k) {
        count_draw();
        const double end = t + set_.trace_length->quantile(draws_.draw(draw_trace, line, k));
        add(t, end);
        t = end + set_.gap->quantile(draws_.draw(draw_bridge, line, k));
    }
}

void SetSampler::count_draw() {
    if (++draw_count_ > max_draws()) fail_too_many("more than " + std::to_string(max_draws()));
}

void SetSampler::fail_too_many(const std::string& count) const {
    throw InputError(
        set_.place, "joint set '" + set_.name + "' needs " + count + " lines and traces",
        "at most " + std::to_string(max_draws()) + " (--max-blocks, " + std::to_string(limit_.max_blocks) +
            ", and " + std::to_string(DrawLimit::allowance) + " more" +
            (limit_.drawn > 0 ? ", less " + std::to_string(limit_.drawn) + " of the sets before it" : "") +
            ")");
}

}  // namespace rockslope::blockgen
