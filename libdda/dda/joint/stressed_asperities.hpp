#pragma once

#include <algorithm>
#include <cmath>

#include "dda/joint/asperity_wear.hpp"

namespace rockslope::dda {

/// Asperities that decay with the plastic work and that are climbed the less the harder the joint is
/// compressed, Eq. (71): the angle of Eq. (70), with one term, times (1 - sigma/sigma_c)^kappa, and nothing
/// above sigma_c. Source: Jing et al. (1993) for the idea that the angle falls with normal stress and with
/// work; the form and the exponent are not checked against the paper, nor is there its dependence on the
/// direction in space. Limits: as for Plesha's; the strength falls with normal stress where the angle falls
/// too fast.
struct StressedAsperitiesSurface {
    static constexpr const char* name = "stressed-asperities";

    double friction_angle = 0;  ///< phi of the flat surface, rad
    double asperity_angle = 0;  ///< a at no stress, rad, not negative; with friction_angle below pi/2
    double wear = 0;            ///< c, m2/J, not negative
    double wall_strength = 0;   ///< sigma_c, Pa, positive
    double exponent = 1;        ///< kappa, positive

    AsperitySurface surface(double normal_force, double length) const {
        // A bare corner has no stress that could be told: its asperities count as crushed.
        const double crushing_force = wall_strength * length;
        if (!(normal_force < crushing_force)) return {friction_angle, {}};
        const double compressed = std::max(normal_force, 0.0);
        const double left = std::pow(1 - compressed / crushing_force, exponent);
        return {
            friction_angle, {{{asperity_angle * left, wear}, {}}}, -exponent / (crushing_force - compressed)};
    }
};

using StressedAsperities = AsperityLaw<StressedAsperitiesSurface>;

}  // namespace rockslope::dda
