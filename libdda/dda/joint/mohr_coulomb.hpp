#pragma once

#include "dda/joint/friction_angle.hpp"
#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Mohr-Coulomb friction with cohesion and tensile strength, Eq. (31): tau = c + sigma_n tan(phi). The peak
/// values hold until the first slip or opening, the residual values thereafter. Source: Shi (1988); the
/// default residual values are his: c and the tensile strength vanish, phi does not change.
struct MohrCoulomb {
    static constexpr const char* name = "mohr-coulomb";
    static constexpr HistoryScope history_scope = HistoryScope::contact;

    FrictionAngle friction_angle = 0;           ///< rad, in [0, pi/2)
    double cohesion = 0;                        ///< Pa
    double tensile_strength = 0;                ///< Pa
    FrictionAngle residual_friction_angle = 0;  ///< rad; the reader's default is friction_angle
    double residual_cohesion = 0;               ///< Pa

    struct History {
        bool broken = false;  ///< slipped or opened once: the residual values hold
        friend bool operator==(const History&, const History&) = default;
    };
    static constexpr std::array<History, 2> common_histories() { return {{{false}, {true}}}; }

    static MohrCoulomb read(const ParameterTable& table);
    Dilates dilates() const { return Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const {
        return CoulombEnvelope{line(false), line(true)};
    }

    History fresh(bool intact) const {
        return {!intact ||
                (cohesion == 0 && tensile_strength == 0 && friction_angle == residual_friction_angle)};
    }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial = {}) const;
    /// tan(phi) where the strength is positive, otherwise 0.
    Strength strength_slope(const History& history, double normal_force, double length) const;
    std::optional<CoulombLine> bound_line(const History& history) const { return line(history.broken); }
    History advance(const History& history, const ContactMotion& motion) const;
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    JointRecord record(const History&) const { return {}; }

  private:
    CoulombLine line(bool broken) const;
};

}  // namespace rockslope::dda
