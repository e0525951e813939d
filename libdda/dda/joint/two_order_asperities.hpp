#pragma once

#include "dda/joint/asperity_wear.hpp"

namespace rockslope::dda {

/// Two orders of asperities, waviness and unevenness, that decay with the plastic work each at its own rate:
/// Eq. (70) with two terms. Source: Lee et al. (2001) as Ma et al. (2017) tell it, the asperity angle as the
/// sum of two; the rates are not checked against the paper. Limits: as for Plesha's.
struct TwoOrderAsperitiesSurface {
    static constexpr const char* name = "two-order-asperities";

    double friction_angle = 0;    ///< phi of the flat surface, rad
    double waviness_angle = 0;    ///< rad, first order, not negative
    double waviness_wear = 0;     ///< m2/J
    double unevenness_angle = 0;  ///< rad, second order, not negative; all three angles below pi/2
    double unevenness_wear = 0;   ///< m2/J

    AsperitySurface surface(double, double) const {
        return {friction_angle, {{{waviness_angle, waviness_wear}, {unevenness_angle, unevenness_wear}}}};
    }
};

using TwoOrderAsperities = AsperityLaw<TwoOrderAsperitiesSurface>;

}  // namespace rockslope::dda
