#include "dda/joint/barton.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/degree.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

double BartonStrength::roughness_angle(double normal_force, double length) const {
    if (!(normal_force > 0) || !(length > 0)) return 0;
    const double quotient = wall_strength * length / normal_force;
    // A quotient that overflows or is subnormal still has an accurate logarithm.
    const double decades = std::isnormal(quotient)
                               ? std::log10(quotient)
                               : std::log10(wall_strength) + std::log10(length) - std::log10(normal_force);
    return roughness_coefficient * std::max(decades, 0.0) * degree;
}

BartonStrength BartonStrength::read(const ParameterTable& table) {
    BartonStrength barton;
    barton.residual_friction_angle = table.checked(
        "residual_friction_angle", table.friction_angle("residual_friction_angle"),
        [](double v) { return v <= largest_angle; }, "at most 70 deg, Barton's limit");
    barton.roughness_coefficient = table.checked(
        "jrc", table.number("jrc", Quantity::number), [](double v) { return v >= 0 && v <= 20; },
        "a joint roughness coefficient from 0 to 20");
    barton.wall_strength = table.positive("jcs", Quantity::stress);
    return barton;
}

double read_damage(const ParameterTable& table) {
    return table.checked(
        "damage", table.not_negative("damage", Quantity::number, 0),
        [](double v) { return v == 0 || (v >= 1 && v <= 2); }, "0 for no dilation, or a number from 1 to 2");
}

double BartonStrength::roughness_angle_log_slope() const {
    return -roughness_coefficient * degree / std::numbers::ln10;
}

/// Barton's strength, Eq. (57).
double BartonStrength::shear_strength(double normal_force, double length, double ratio) const {
    return std::max(normal_force, 0.0) * std::tan(total_angle(roughness_angle(normal_force, length), ratio));
}

double BartonStrength::slope(double normal_force, double length, double ratio) const {
    if (!(normal_force > 0)) return 0;
    const double roughness = roughness_angle(normal_force, length);
    const double angle = total_angle(roughness, ratio), tangent = std::tan(angle);
    if (free_angle(roughness, ratio) != angle || roughness == 0) return tangent;
    return tangent + ratio * roughness_angle_log_slope() * (1 + tangent * tangent);
}

}  // namespace rockslope::dda
