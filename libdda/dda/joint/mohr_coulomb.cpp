#include "dda/joint/mohr_coulomb.hpp"

#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

/// The peak or the residual line of Eq. (31). Tension on an intact joint reduces its cohesion.
CoulombLine MohrCoulomb::line(bool broken) const {
    if (broken) return {residual_friction_angle.coefficient(), residual_cohesion, false};
    return {friction_angle.coefficient(), cohesion, true};
}

Strength MohrCoulomb::strength(const History& history, double normal_force, double length,
                               const ShearTrial&) const {
    const double shear = line(history.broken).strength(normal_force, length);
    return {shear, shear, history.broken ? 0 : tensile_strength * length};
}

Strength MohrCoulomb::strength_slope(const History& history, double normal_force, double length) const {
    if (history.broken) {
        const double slope = normal_force > 0 ? residual_friction_angle.coefficient() : 0;
        return {slope, slope, 0};
    }
    const double friction = friction_angle.coefficient();
    const double slope = normal_force * friction + cohesion * length > 0 ? friction : 0;
    return {slope, slope, 0};
}

/// A closing contact slips below the peak strength, Eq. (75), and stays intact.
MohrCoulomb::History MohrCoulomb::advance(const History& history, const ContactMotion& motion) const {
    const bool breaks = motion.slip != 0 && !motion.closing && !motion.bond_holds;
    return {history.broken || motion.opened || breaks};
}

MohrCoulomb MohrCoulomb::read(const ParameterTable& table) {
    MohrCoulomb law;
    law.friction_angle = table.friction_angle("friction_angle");
    law.cohesion = table.not_negative("cohesion", Quantity::stress, 0);
    law.tensile_strength = table.not_negative("tensile_strength", Quantity::stress, 0);
    law.residual_friction_angle = table.friction_angle("residual_friction_angle", law.friction_angle);
    law.residual_cohesion = table.not_negative("residual_cohesion", Quantity::stress, 0);
    return law;
}

}  // namespace rockslope::dda
