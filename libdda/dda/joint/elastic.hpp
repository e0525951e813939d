#pragma once

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// A joint that neither opens nor slips, Eq. (45): only its springs deform. With the joint's own normal and
/// shear stiffness it is the linear displacement discontinuity of wave studies [pyraknolte1990]; with stiff
/// springs it glues blocks together. Faces that meet later in the run are not bonded: they open freely, and
/// have a friction coefficient of 20, 87 degrees. Limit: the tensile strength is infinite, so the law cannot
/// describe failure.
struct Elastic {
    static constexpr const char* name = "elastic";
    static constexpr HistoryScope history_scope = HistoryScope::contact;

    struct History {
        bool bonded = false;
        friend bool operator==(const History&, const History&) = default;
    };

    static constexpr std::array<History, 2> common_histories() { return {{{false}, {true}}}; }

    static Elastic read(const ParameterTable&) { return {}; }
    Dilates dilates() const { return Dilates::never; }
    std::optional<CoulombEnvelope> coulomb_envelope() const { return std::nullopt; }
    History fresh(bool intact) const { return {intact}; }
    Strength strength(const History& history, double normal_force, double length,
                      const ShearTrial& trial = {}) const;
    std::optional<Strength> strength_slope(const History&, double, double) const { return std::nullopt; }
    std::optional<CoulombLine> bound_line(const History&) const { return std::nullopt; }
    History advance(const History& history, const ContactMotion&) const { return history; }
    double shear_stiffness(const History&, double, double) const { return 0; }
    LockedDilation locked_dilation(const History&) const { return {}; }
    JointRecord record(const History&) const { return {}; }
};

}  // namespace rockslope::dda
