#pragma once

namespace rockslope::dda {

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

    /// i, rad, not negative. @param normal_force N per metre; @param length m, of joint that it acts on:
    /// their ratio is the stress. 0 in tension and for a bare corner, whose stress has no bound.
    double roughness_angle(double normal_force, double length) const;
    /// N di/dN, rad, where i is above 0.
    double roughness_angle_log_slope() const;
    /// phi_r + ratio * i within its limits, rad. @param ratio mobilised over peak roughness.
    double total_angle(double roughness_angle, double ratio) const;
    /// N per metre.
    double shear_strength(double normal_force, double length, double ratio) const;
    /// Its derivative with respect to the normal force at constant length and ratio.
    double slope(double normal_force, double length, double ratio) const;
};

}  // namespace rockslope::dda
