#include "blockgen/picture/equal_area.hpp"

#include <cmath>
#include <numbers>

namespace rockslope::blockgen {

namespace {

constexpr int half_circle_steps = 60;  // of half a circle

}  // namespace

Point equal_area(const SpaceDirection& direction) {
    const double sign = direction.down < 0 ? -1 : 1;
    // sqrt(2) sin(t / 2) / sin(t) = 1 / sqrt(1 + cos(t))
    const double scale = sign / std::sqrt(1 + sign * direction.down);
    return {scale * direction.east, scale * direction.north};
}

SpaceDirection direction_at(const Point& p) {
    // r = sqrt(2) sin(t / 2): cos(t) = 1 - r^2, and sin(t) / r = sqrt(2) cos(t / 2).
    const double square = p.x * p.x + p.y * p.y, scale = std::sqrt(2 - square);
    return {scale * p.x, scale * p.y, 1 - square};
}

std::vector<Point> great_circle(double dip, double dip_direction) {
    const double sine = std::sin(dip_direction), cosine = std::cos(dip_direction);
    std::vector<Point> curve;
    for (int k = 0; k <= half_circle_steps; ++k) {
        const double t = std::numbers::pi * k / half_circle_steps, strike = std::cos(t),
                     down_dip = std::sin(t);
        // The ends of the strike line lie at the rim exactly, not on the other side of it by rounding.
        curve.push_back(equal_area({-strike * cosine + down_dip * std::cos(dip) * sine,
                                    strike * sine + down_dip * std::cos(dip) * cosine,
                                    k == 0 || k == half_circle_steps ? 0 : down_dip * std::sin(dip)}));
    }
    return curve;
}

std::vector<Point> small_circle(double angle) {
    std::vector<Point> curve;
    for (int k = 0; k <= half_circle_steps; ++k) {
        const double t = std::numbers::pi * k / half_circle_steps;
        curve.push_back(equal_area({std::sin(angle) * std::cos(t), std::cos(angle),
                                    k == 0 || k == half_circle_steps ? 0 : std::sin(angle) * std::sin(t)}));
    }
    return curve;
}

}  // namespace rockslope::blockgen
