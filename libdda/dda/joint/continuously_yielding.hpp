#pragma once

#include <cstdint>

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// A joint that yields from the start of its loading, Eq. (73) and (74): the shear stress nears a bounding
/// strength tau_m = sigma_n tan(phi_m) the more slowly the nearer it is, and phi_m falls with the plastic
/// displacement by which asperities are damaged. Source: the model of Cundall and Hart (1984) as manuals of
/// distinct element programs tell it; not checked against the paper. Two things differ from there: the factor
/// r is not negative, so that unloading is elastic and no reversal makes energy; and the joint does not
/// dilate.
///
/// Limits: the spring is the contact's, not a power of the normal stress. Each change of direction, however
/// small, gives the joint some of its elastic stiffness back. Where the shear spring is so stiff that the
/// bound is neared within a two-hundredth of `roughness_length`, the way is integrated to second order only,
/// and to fourth elsewhere.
struct ContinuouslyYielding {
    static constexpr const char* name = "continuously-yielding";

    double friction_angle = 0;           ///< rad, of the bounding strength at first, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad, of the surface when worn, at most friction_angle
    double roughness_length = 0;         ///< R, m, positive: plastic displacement over which damage goes on

    struct History {
        double plastic = 0;          ///< m, displacement, whichever way
        double unloading = 0;        ///< r: stress over bounding strength at the last reversal
        std::int64_t direction = 0;  ///< sign of the last displacement; 0 before it
        friend bool operator==(const History&, const History&) = default;
    };

    History fresh(bool) const { return {}; }
    /// @param trial without a stiffness the bounding strength at the end of the displacement.
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const;
    History advance(const History& history, const ContactMotion& motion) const;
    /// The mobilised ratio is the share of the first friction over the worn one that is left.
    JointRecord record(const History& history) const;

  private:
    double bounding_tangent(double plastic) const;
};

}  // namespace rockslope::dda
