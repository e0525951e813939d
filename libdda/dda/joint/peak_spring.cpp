#include "dda/joint/peak_spring.hpp"

#include <algorithm>

namespace rockslope::dda {

PeakSpring PeakSpring::loaded(const NormalLoad& load, const BartonStrength& barton,
                              double peak_displacement) const {
    if (!(load.normal_force > 0) || !(load.length > 0)) return *this;
    PeakSpring after = *this;
    after.length = load.length;
    if (found == at_rest && !load.at_rest) return after;
    const bool lands = found == after_a_rest && !load.at_rest;
    if (load.at_rest) after.found = at_rest;
    const double stress = load.stressed_length > 0 ? load.normal_force / load.stressed_length : 0;
    if (!(peak_displacement > 0)) {
        if (!lands) after.normal_stress = std::max(normal_stress, stress);
        return after;
    }
    // The spring to the peak, Eq. (58).
    const double stiffened =
        barton.shear_strength(load.normal_force, load.stressed_length, 1) / peak_displacement;
    if (!(stiffened > stiffness)) return after;
    after.stiffness = stiffened;
    if (lands) return after;
    after.normal_force = load.normal_force;
    after.normal_stress = stress;
    return after;
}

double PeakSpring::stiffness_of_part(double part) const {
    return length > 0 ? stiffness * std::min(part / length, 1.0) : 0;
}

}  // namespace rockslope::dda
