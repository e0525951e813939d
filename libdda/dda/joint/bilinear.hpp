#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// Patton's bilinear joint, Eq. (69). Its teeth have the inclination i. The joint climbs over them at low
/// normal stress and shears them off above a transition stress sigma_T,
///
///     tau = sigma tan(phi + i)                                        for sigma <= sigma_T
///     tau = sigma_T tan(phi + i) + (sigma - sigma_T) tan(phi_r)       above.
///
/// The first slip above the transition removes the teeth: tau = sigma tan(phi_r) from then on. Source: Patton
/// (1966) for the two lines; the permanent loss of the teeth is an assumption made here. Limits: no dilation;
/// the strength drops at once at the first slip above the transition.
struct Bilinear {
    static constexpr const char* name = "bilinear";
    static constexpr HistoryScope history_scope = HistoryScope::contact;

    double friction_angle = 0;           ///< rad, basic angle plus i, in [0, pi/2)
    double residual_friction_angle = 0;  ///< rad, at most friction_angle
    double transition_stress = 0;        ///< Pa

    struct History {
        bool sheared_off = false;
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr std::array<History, 2> common_histories() { return {{{false}, {true}}}; }

    static Bilinear read(const ParameterTable& table);
    Dilates dilates() const { return Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    /// @param intact false for faces that met later: their teeth do not match.
    History fresh(bool intact) const { return {!intact}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial = {}) const;
    Strength strength_slope(const History& history, double normal_force, double length) const;
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion& motion) const;
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    JointRecord record(const History&) const { return {}; }
};

}  // namespace rockslope::dda
