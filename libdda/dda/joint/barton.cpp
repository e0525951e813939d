#include "dda/joint/barton.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockslope::dda {

namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

double BartonStrength::roughness_angle(double normal_force, double length) const {
    if (!(normal_force > 0) || !(length > 0)) return 0;
    const double quotient = wall_strength * length / normal_force;
    // Where the quotient leaves the numbers that are held in full, its logarithm does not.
    const double decades = std::isnormal(quotient)
                               ? std::log10(quotient)
                               : std::log10(wall_strength) + std::log10(length) - std::log10(normal_force);
    return roughness_coefficient * std::max(decades, 0.0) * degree;
}

double BartonStrength::roughness_angle_log_slope() const {
    return -roughness_coefficient * degree / std::numbers::ln10;
}

double BartonStrength::total_angle(double roughness_angle, double ratio) const {
    return std::clamp(residual_friction_angle + ratio * roughness_angle, 0.0, largest_angle);
}

double BartonStrength::shear_strength(double normal_force, double length, double ratio) const {
    return std::max(normal_force, 0.0) * std::tan(total_angle(roughness_angle(normal_force, length), ratio));
}

double BartonStrength::slope(double normal_force, double length, double ratio) const {
    if (!(normal_force > 0)) return 0;
    const double roughness = roughness_angle(normal_force, length);
    const double free_angle = residual_friction_angle + ratio * roughness;
    const double angle = total_angle(roughness, ratio), tangent = std::tan(angle);
    if (free_angle != angle || roughness == 0) return tangent;
    return tangent + ratio * roughness_angle_log_slope() * (1 + tangent * tangent);
}

}  // namespace rockslope::dda
