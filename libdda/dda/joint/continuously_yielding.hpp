#pragma once

#include <cstdint>

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// A joint that yields from the start of its loading, Eqs. (73) and (74). The shear stress approaches a
/// bounding strength tau_m = sigma_n tan(phi_m) at a rate that falls with the distance from it, and phi_m
/// falls with the plastic displacement that damages the asperities. Source: the model of Cundall and Hart
/// (1984) after manuals of distinct element programs; not checked against the paper. Two things differ: the
/// factor r is not negative, so unloading is elastic and no reversal generates energy; the joint does not
/// dilate.
///
/// Limits: the spring is the contact's, not a power of the normal stress. Each change of direction, however
/// small, restores some of the elastic stiffness. Where the shear spring is so stiff that the stress reaches
/// the bound within 1/200 of `roughness_length`, the integration is of second order, elsewhere of fourth.
struct ContinuouslyYielding {
    static constexpr const char* name = "continuously-yielding";
    static constexpr HistoryScope history_scope = HistoryScope::joint_segment;

    double friction_angle = 0;           ///< rad, of the initial bounding strength, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad, of the worn surface, at most friction_angle
    double roughness_length = 0;         ///< R, m, positive: phi_m - phi_r falls by a factor e over it

    struct History {
        double plastic = 0;          ///< m, accumulated displacement, regardless of direction
        double unloading = 0;        ///< r: stress over bounding strength at the last reversal
        std::int64_t direction = 0;  ///< sign of the last displacement; 0 before it
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr NoCommonHistories<History> common_histories() { return {}; }

    static ContinuouslyYielding read(const ParameterTable& table);
    Dilates dilates() const { return Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    History fresh(bool) const { return {}; }
    /// @param trial with stiffness 0, the result is the bounding strength at the end of the displacement.
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial) const;
    std::optional<Strength> strength_slope(const History&, double, double) const { return std::nullopt; }
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion& motion) const;
    /// The law has no position, and nothing wears in the air.
    History fly(const History& history, const ContactMotion&) const { return history; }
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    /// The mobilised ratio is the remaining fraction of friction_angle - residual_friction_angle.
    JointRecord record(const History& history) const;

  private:
    double bounding_tangent(double plastic) const;
};

}  // namespace rockslope::dda
