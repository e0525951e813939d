#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Cohesion and friction that fall with the slip, Eq. (68): both go from their peak to their residual value,
/// linearly over a slip D or like exp(-U/D), with U the accumulated magnitude of the plastic slip. Sources:
/// Wang et al. (2013) weaken cohesion and friction, Sitar et al. (2005) friction; the two curves here are not
/// checked against the papers. Limits: no dependence on velocity or on the direction of slip; no recovery. A
/// joint that softens faster than its spring and its blocks unload is unstable, and its force then drops
/// within a step.
struct Weakening {
    static constexpr const char* name = "weakening";
    static constexpr HistoryScope history_scope = HistoryScope::contact;

    double friction_angle = 0;           ///< rad, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad
    double cohesion = 0;                 ///< Pa
    double residual_cohesion = 0;        ///< Pa, at most the cohesion
    double slip = 0;                     ///< D, m, positive
    bool exponential = false;            ///< linear otherwise

    struct History {
        double slip = 0;  ///< U, m
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr NoCommonHistories<History> common_histories() { return {}; }

    static Weakening read(const ParameterTable& table);
    Dilates dilates() const { return Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    /// @param intact false for faces that met later: they have their residual strength.
    History fresh(bool intact) const;
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    /// The strength falls within the trial displacement, so the bound is no line.
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion& motion) const;
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    JointRecord record(const History&) const { return {}; }

  private:
    double remaining_fraction(double slip) const;
    double bound(double slip, double normal_force, double length) const;
    double bound_slope(double slip, double normal_force, double length) const;
};

}  // namespace rockslope::dda
