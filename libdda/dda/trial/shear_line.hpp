#pragma once

#include <algorithm>

namespace rockslope::dda {

/// The shear bound of a contact, in its sliding direction, as a line over its normal force.
struct ShearLine {
    double slope = 0;
    double cohesion = 0;             ///< N per metre, bound at zero normal force
    double lowest_normal_force = 0;  ///< N per metre, the normal force below which the bound falls no further
    bool is_missing = false;         ///< its joint segment has to compute it first

    double at(double normal) const { return slope * std::max(normal, lowest_normal_force) + cohesion; }
};

}  // namespace rockslope::dda
