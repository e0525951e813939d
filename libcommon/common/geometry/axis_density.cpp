#include "common/geometry/axis_density.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

namespace rockslope {

namespace {

/// Side of the cells in which axes are taken together; dimensionless, of the unit sphere.
constexpr double cell = 0.01;

SpaceDirection unit(const SpaceDirection& v) {
    const double length = std::sqrt(dot(v, v));
    return {v.east / length, v.north / length, v.down / length};
}

void add(SpaceDirection& sum, const SpaceDirection& v, double times) {
    sum.east += times * v.east;
    sum.north += times * v.north;
    sum.down += times * v.down;
}

SpaceDirection downward(const SpaceDirection& v) {
    return v.down < 0 ? SpaceDirection{-v.east, -v.north, -v.down} : v;
}

}  // namespace

AxisDensity::AxisDensity(std::span<const SpaceDirection> axes) : count_(axes.size()) {
    constexpr double largest_concentration = 500, counted_deviations = 3;
    const auto n = static_cast<double>(count_);
    concentration_ = std::min(2 * (1 + n / (counted_deviations * counted_deviations)), largest_concentration);
    std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t>, Group> cells;
    for (const SpaceDirection& axis : axes) {
        const SpaceDirection a = downward(axis);
        Group& group = cells
                           .try_emplace({std::llround(a.east / cell), std::llround(a.north / cell),
                                         std::llround(a.down / cell)},
                                        Group{{0, 0, 0}, 0})
                           .first->second;
        add(group.axis, a, 1);
        ++group.count;
    }
    for (const auto& [place, group] : cells) groups_.push_back({unit(group.axis), group.count});
}

AxisDensity::Weight AxisDensity::weight_of(const Group& group, const SpaceDirection& direction) const {
    constexpr double negligible = 40;  // exp(-40) is below the rounding of a sum of which one term is 1
    const double cosine = dot(group.axis, direction), exponent = concentration_ * (1 - std::abs(cosine));
    return {exponent > negligible ? 0 : group.count * std::exp(-exponent), cosine < 0 ? -1.0 : 1.0};
}

double AxisDensity::at(const SpaceDirection& direction) const {
    double sum = 0;
    for (const Group& group : groups_) sum += weight_of(group, direction).value;
    return sum * concentration_ / (static_cast<double>(count_) * -std::expm1(-concentration_));
}

double AxisDensity::uniform_deviation() const {
    const double half = concentration_ / 2;
    return std::sqrt((half / std::tanh(half) - 1) / static_cast<double>(count_));
}

SpaceDirection AxisDensity::weighted_mean(const SpaceDirection& direction) const {
    SpaceDirection sum{0, 0, 0};
    for (const Group& group : groups_) {
        const Weight weight = weight_of(group, direction);
        add(sum, group.axis, weight.side * weight.value);
    }
    return unit(sum);
}

AxisDensity::Peak AxisDensity::peak() const {
    constexpr int most_uphill_steps = 1000;
    constexpr double least_gain = 1e-12;
    Peak best;
    for (const Group& group : groups_)
        if (const double density = at(group.axis); density > best.density) best = {group.axis, density};
    for (int k = 0; k < most_uphill_steps; ++k) {
        const SpaceDirection next = weighted_mean(best.axis);
        const double density = at(next);
        if (!(density > best.density * (1 + least_gain))) break;
        best = {next, density};
    }
    return {downward(best.axis), best.density};
}

}  // namespace rockslope
