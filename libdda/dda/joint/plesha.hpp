#pragma once

#include "dda/joint/asperity_wear.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

/// Plesha's joint: one order of asperities whose angle decays with the plastic work, Eq. (70) with one term.
/// Source: Plesha (1987) for the form of the law; the parameters are the user's. Limits: the asperities are
/// symmetric about the origin; only work wears them; their angle does not depend on the normal stress.
struct PleshaSurface {
    static constexpr const char* name = "plesha";

    double friction_angle = 0;  ///< phi of the flat surface, rad
    double asperity_angle = 0;  ///< a, rad, not negative; with friction_angle below pi/2
    double wear = 0;            ///< c, m2/J, not negative

    static PleshaSurface read(const ParameterTable& table) {
        PleshaSurface law;
        law.friction_angle = table.friction_angle("friction_angle");
        law.asperity_angle = read_asperity_angle(table, "asperity_angle", law.friction_angle);
        law.wear = read_asperity_wear(table, "wear");
        return law;
    }
    /// The asperities, the same at each normal force.
    AsperitySurface surface(double, double) const { return {friction_angle, {{{asperity_angle, wear}, {}}}}; }
};

using Plesha = AsperityLaw<PleshaSurface>;

}  // namespace rockslope::dda
