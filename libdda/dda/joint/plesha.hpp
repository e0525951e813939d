#pragma once

#include "dda/joint/asperity_wear.hpp"

namespace rockslope::dda {

/// Plesha's joint: one order of asperities whose angle decays with the plastic work, Eq. (70) with one term.
/// Source: Plesha (1987), from which the form of the law is known; the numbers of a joint are the user's.
/// Limits: the asperities are symmetric about the origin, and no crushing but by work; the law has no
/// dependence of the angle on stress.
struct PleshaSurface {
    static constexpr const char* name = "plesha";

    double friction_angle = 0;  ///< phi of the flat surface, rad
    double asperity_angle = 0;  ///< a, rad, not negative; with friction_angle below pi/2
    double wear = 0;            ///< c, m2/J, not negative

    AsperitySurface surface(double, double) const { return {friction_angle, {{{asperity_angle, wear}, {}}}}; }
};

using Plesha = AsperityLaw<PleshaSurface>;

}  // namespace rockslope::dda
