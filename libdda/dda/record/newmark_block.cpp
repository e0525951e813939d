#include "dda/record/newmark_block.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dda {

namespace {

constexpr double longest_piece = 2.5e-4;  // s

/// The block's speed after `dt` under a drive and a strength, m/s2. Friction stops a block, and does not turn
/// it round.
double next_speed(double speed, double drive, double strength, double dt) {
    if (speed == 0 && std::abs(drive) <= strength) return 0;
    const double direction = speed != 0 ? speed : drive;
    const double next = speed + dt * (drive - std::copysign(strength, direction));
    return next * direction < 0 ? 0 : next;
}

}  // namespace

double yield_coefficient(const SlidingPlane& plane) {
    return std::tan(plane.friction - plane.dip);
}

std::vector<double> newmark_slip(const Accelerogram& record, const SlidingPlane& plane, double gravity) {
    const auto in_range = [](double angle) { return angle >= 0 && angle < std::numbers::pi / 2; };
    if (!in_range(plane.dip) || !in_range(plane.friction))
        throw std::invalid_argument("dip and friction must be at least 0 and below 90 degrees");
    const double sine = std::sin(plane.dip), cosine = std::cos(plane.dip), mu = std::tan(plane.friction);
    const int pieces = std::max(1, static_cast<int>(std::ceil(record.step / longest_piece)));
    const double dt = record.step / pieces;
    std::vector<double> slip(record.values.size(), 0.0);
    double speed = 0;
    for (std::size_t k = 1; k < slip.size(); ++k) {
        slip[k] = slip[k - 1];
        for (int piece = 0; piece < pieces; ++piece) {
            const double a = std::lerp(record.values[k - 1], record.values[k], (piece + 0.5) / pieces);
            const double strength = mu * std::max(0.0, gravity * cosine + a * sine);
            const double next = next_speed(speed, gravity * sine - a * cosine, strength, dt);
            slip[k] += dt * (speed + next) / 2;
            speed = next;
        }
    }
    return slip;
}

}  // namespace dda
