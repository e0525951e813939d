#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Friction that falls with the speed of slip, Eq. (72): tan(phi) goes from its static to its residual value
/// like exp(-v/v_c) or, with a `rate` b, as tan(phi) - b ln(1 + v/v_c) down to the residual value. Sources:
/// Sitar et al. (2005) and Bakun-Mazor et al. (2012) use velocity-dependent friction in DDA; the logarithm is
/// that of steady rate-and-state friction; neither the curves nor any number is checked against the papers.
/// Limits: the speed is that of the faces in the last accepted step if it slipped, so the strength lags by
/// one step; no ageing, no slip distance over which the friction adapts; full recovery as soon as the joint
/// rests. A step without a duration is static.
struct VelocityWeakening {
    static constexpr const char* name = "velocity-weakening";
    static constexpr HistoryScope history_scope = HistoryScope::joint_segment;

    double friction_angle = 0;           ///< rad, at rest, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad, at most friction_angle
    double speed = 0;                    ///< v_c, m/s, positive
    double rate = 0;                     ///< b, not negative; 0: the exponential

    struct History {
        double speed = 0;  ///< m/s, of the faces in the last step, 0 unless it slipped
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr NoCommonHistories<History> common_histories() { return {}; }

    static VelocityWeakening read(const ParameterTable& table);
    Dilates dilates() const { return Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    History fresh(bool) const { return {}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial = {}) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    /// None: a joint segment's strength is linearised with its other contacts.
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion& motion) const;
    /// An open joint rests.
    History fly(const History&, const ContactMotion&) const { return {}; }
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    /// The mobilised ratio is (tan phi - residual) / (static - residual).
    JointRecord record(const History& history) const;

  private:
    double friction(double speed) const;
};

}  // namespace rockslope::dda
