#pragma once

#include "dda/joint/asperity_wear.hpp"
#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

/// Two orders of asperities, waviness and unevenness, each of which decays with the plastic work at its own
/// rate: Eq. (70) with two terms. Source: Lee et al. (2001) as cited by Ma et al. (2017), where the asperity
/// angle is the sum of two; the rates are not checked against the paper. Limits: those of Plesha's law.
struct TwoOrderAsperitiesSurface {
    static constexpr const char* name = "two-order-asperities";

    double friction_angle = 0;    ///< phi of the flat surface, rad
    double waviness_angle = 0;    ///< rad, first order, not negative
    double waviness_wear = 0;     ///< m2/J
    double unevenness_angle = 0;  ///< rad, second order, not negative; all three angles below pi/2
    double unevenness_wear = 0;   ///< m2/J

    static TwoOrderAsperitiesSurface read(const ParameterTable& table) {
        TwoOrderAsperitiesSurface law;
        law.friction_angle = table.friction_angle("friction_angle");
        law.waviness_angle = read_asperity_angle(table, "waviness_angle", law.friction_angle);
        law.waviness_wear = read_asperity_wear(table, "waviness_wear");
        law.unevenness_angle =
            read_asperity_angle(table, "unevenness_angle", law.friction_angle + law.waviness_angle);
        law.unevenness_wear = read_asperity_wear(table, "unevenness_wear");
        return law;
    }
    /// The asperities of both orders, the same at each normal force.
    AsperitySurface surface(double, double) const {
        return {friction_angle, {{{waviness_angle, waviness_wear}, {unevenness_angle, unevenness_wear}}}};
    }
};

using TwoOrderAsperities = AsperityLaw<TwoOrderAsperitiesSurface>;

}  // namespace rockslope::dda
