#pragma once

#include <algorithm>
#include <cmath>

#include "dda/joint/asperity_wear.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

/// Asperities whose angle falls with the plastic work and with the normal stress, Eq. (71): the angle of
/// Eq. (70), with one term, times (1 - sigma/sigma_c)^kappa, and 0 above sigma_c. Source: Jing et al. (1993)
/// let the angle fall with normal stress and with work; the form and the exponent are not checked against the
/// paper, and its dependence on the direction in space is missing here. Limits: those of Plesha's law; the
/// strength falls with the normal stress where the angle falls too fast.
struct StressedAsperitiesSurface {
    static constexpr const char* name = "stressed-asperities";

    double friction_angle = 0;  ///< phi of the flat surface, rad
    double asperity_angle = 0;  ///< a at no stress, rad, not negative; with friction_angle below pi/2
    double wear = 0;            ///< c, m2/J, not negative
    double wall_strength = 0;   ///< sigma_c, Pa, positive
    double exponent = 1;        ///< kappa, positive

    static StressedAsperitiesSurface read(const ParameterTable& table) {
        StressedAsperitiesSurface law;
        law.friction_angle = table.friction_angle("friction_angle");
        law.asperity_angle = read_asperity_angle(table, "asperity_angle", law.friction_angle);
        law.wear = read_asperity_wear(table, "wear");
        law.wall_strength = table.positive("wall_strength", Quantity::stress);
        law.exponent = table.positive("exponent", Quantity::number, 1);
        return law;
    }
    /// The asperities under a normal force, Eq. (71). @param normal_force N per metre; @param length m, of
    /// the contact.
    AsperitySurface surface(double normal_force, double length) const {
        // A bare vertex has no length and an infinite stress: its asperities are crushed.
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
