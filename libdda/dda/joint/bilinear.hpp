#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Patton's bilinear joint, Eq. (69): teeth of inclination i that are climbed at low normal stress and cut
/// off above a transition stress sigma_T,
///
///     tau = sigma tan(phi + i)                                        for sigma <= sigma_T
///     tau = sigma_T tan(phi + i) + (sigma - sigma_T) tan(phi_r)       above.
///
/// Once the joint has slipped above the transition the teeth are gone: tau = sigma tan(phi_r). Source: Patton
/// (1966) for the two lines; that the teeth do not come back is ours. Limits: no dilation; the drop at the
/// first slip above the transition is at once.
struct Bilinear {
    static constexpr const char* name = "bilinear";

    double friction_angle = 0;           ///< rad, basic angle plus teeth, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad, at most friction_angle
    double transition_stress = 0;        ///< Pa

    struct History {
        bool sheared_off = false;
        friend bool operator==(const History&, const History&) = default;
    };

    /// What a joint starts with. @param intact is false for faces that met later: their teeth do not match.
    History fresh(bool intact) const { return {!intact}; }
    Strength strength(const History& history, double normal_force, double length) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    History advance(const History& history, const ContactMotion& motion) const;
};

}  // namespace rockslope::dda
