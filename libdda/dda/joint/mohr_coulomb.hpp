#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Mohr-Coulomb friction with cohesion and tensile strength, Eq. (31): tau = c + sigma_n tan(phi), intact
/// until the first slip or opening, thereafter with the residual values. Source: Shi (1988); the default
/// residual is Shi's (c and tensile strength vanish, phi stays).
struct MohrCoulomb {
    static constexpr const char* name = "mohr-coulomb";

    double friction_angle = 0;           ///< rad, in [0, pi/2)
    double cohesion = 0;                 ///< Pa
    double tensile_strength = 0;         ///< Pa
    double residual_friction_angle = 0;  ///< rad; the reader's default is friction_angle
    double residual_cohesion = 0;        ///< Pa

    struct History {
        bool broken = false;  ///< slipped or opened once: the residual values hold
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool intact) const {
        return {!intact ||
                (cohesion == 0 && tensile_strength == 0 && friction_angle == residual_friction_angle)};
    }
    /// @param normal_force N per metre, compression positive; @param length m, the contact's share of the
    /// joint.
    Strength strength(const History& history, double normal_force, double length) const;
    /// tan(phi) where the joint is pressed or its cohesion holds, 0 where nothing does.
    Strength strength_slope(const History& history, double normal_force, double length) const;
    /// The history after an accepted step.
    History advance(const History& history, const ContactMotion& motion) const;
};

}  // namespace rockslope::dda
