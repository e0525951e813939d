#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Friction that falls with the speed of slip, Eq. (72): tan(phi) goes from its static to its least value
/// like exp(-v/v_c) or, with a `rate` b, as tan(phi) - b ln(1 + v/v_c) until the least value is reached.
/// Sources: velocity-dependent friction in discontinuous deformation analysis is that of Sitar et al. (2005)
/// and Bakun-Mazor et al. (2012), the logarithm that of steady rate-and-state friction; neither the curves
/// nor any number is checked against the papers. Limits: the speed is that of the faces in the last accepted
/// step if it slipped, so the strength follows it one step late; there is no ageing and no slip over which
/// the friction adapts; what was lost is there again as soon as the joint rests. A step that does not tell
/// its duration is static.
struct VelocityWeakening {
    static constexpr const char* name = "velocity-weakening";

    double friction_angle = 0;           ///< rad, at rest, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad, at most friction_angle
    double speed = 0;                    ///< v_c, m/s, positive
    double rate = 0;                     ///< b, not negative; 0: the exponential

    struct History {
        double speed = 0;  ///< m/s, of the faces in the last step, 0 unless it slipped
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool) const { return {}; }
    Strength strength(const History& history, double normal_force, double length) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    History advance(const History& history, const ContactMotion& motion) const;
    /// The mobilised ratio is the share of the friction between rest and least that is left.
    JointRecord record(const History& history) const;

  private:
    double friction(double speed) const;
};

}  // namespace rockslope::dda
