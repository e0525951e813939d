#pragma once

#include <algorithm>

namespace rockslope::dda {

class ParameterTable;

/// Barton's strength of a rough joint, Eq. (57): tau = sigma_n tan(phi_r + ratio * i) with the roughness
/// angle i = JRC log10(JCS / sigma_n), in degrees. Source: Barton (1973), Barton and Bandis (1982). Limits: i
/// >= 0, i.e. no roughness above sigma_n = JCS; the total angle between 0 and 70 deg [barton1973]; no
/// strength in tension. The slope d tau / d sigma_n turns negative where sin(2 angle) < 2 JRC pi / (180 ln
/// 10), e.g. for phi_r below 9 deg with a JRC of 20 near sigma_n = JCS: no rock joint is there.
struct BartonStrength {
    double roughness_coefficient = 0;    ///< JRC at peak, 0 to 20
    double wall_strength = 0;            ///< JCS, Pa
    double residual_friction_angle = 0;  ///< phi_r, rad, of the flat but weathered surface

    static constexpr double largest_angle = 1.2217304763960306;  ///< 70 deg, rad

    /// `residual_friction_angle`, `jrc` and `jcs` of a joint material. @throws InputError.
    static BartonStrength read(const ParameterTable& table);
    /// i, rad, not negative; 0 in tension, and at a bare vertex, where the stress is infinite. @param
    /// normal_force N per metre; @param length m, of the joint under that force: the ratio is the stress.
    double roughness_angle(double normal_force, double length) const;
    /// N di/dN, rad, where i > 0.
    double roughness_angle_log_slope() const;
    /// phi_r + ratio * i, rad, before its limits. @param ratio mobilised over peak roughness.
    double free_angle(double roughness_angle, double ratio) const {
        return residual_friction_angle + ratio * roughness_angle;
    }
    /// The same within its limits.
    double total_angle(double roughness_angle, double ratio) const {
        return std::clamp(free_angle(roughness_angle, ratio), 0.0, largest_angle);
    }
    /// Eq. (57), N per metre.
    double shear_strength(double normal_force, double length, double ratio) const;
    /// Derivative of the shear strength with respect to the normal force at constant length and ratio.
    double slope(double normal_force, double length, double ratio) const;
};

/// The damage coefficient M of Eq. (60), key `damage`: 0 for no dilation, or 1 to 2. @throws InputError.
double read_damage(const ParameterTable& table);

}  // namespace rockslope::dda
