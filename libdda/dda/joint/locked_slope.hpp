#pragma once

#include <algorithm>

#include "dda/joint/joint_types.hpp"

namespace rockslope::dda {

/// A slip that keeps the direction and grows the distance of a joint from its origin.
struct PayingSlip {
    double normal_force = 0;  ///< N per metre, positive
    double stiffness = 0;     ///< of the shear spring, N/m per metre; 0: unknown
    double distance = 0;      ///< m, of the walls while the joint slid
    double rise = 0;          ///< of the strength over the normal force on this way
};

/// The slope of the locked joint after a slip, theory sec. 18. It follows that of the place no faster than
/// the slip pays for: a slope that falls at the same shear force stretches the spring, and stores energy.
/// @param of_place the slope by the roughness there; @param before the slip; @param direction of the slip, -1
/// or 1.
inline double slope_paid_by_slip(double of_place, double before, int direction, const PayingSlip& slip) {
    if (!(slip.stiffness > 0)) return of_place;
    const double most = std::max(slip.stiffness * slip.distance / slip.normal_force - slip.rise, 0.0);
    return direction * std::max(direction * of_place, direction * before - most);
}

/// The slope of a locked joint, no steeper than its strength can climb: what is steeper is crushed.
/// @param strength under the normal force, N per metre, positive.
inline double slope_within(double slope, const Strength& strength, double normal_force) {
    return std::clamp(slope, -strength.backward / normal_force, strength.forward / normal_force);
}

}  // namespace rockslope::dda
