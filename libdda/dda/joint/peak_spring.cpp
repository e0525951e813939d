#include "dda/joint/peak_spring.hpp"

#include <algorithm>

namespace rockslope::dda {

PeakSpring PeakSpring::loaded(const NormalLoad& load, const BartonStrength& barton,
                              double peak_displacement) const {
    if (!(load.normal_force > 0) || !(load.length > 0) || !(peak_displacement > 0)) return *this;
    PeakSpring after = *this;
    after.length = load.length;
    if (found_at_rest != 0 && !load.at_rest) return after;
    const double found = barton.shear_strength(load.normal_force, load.stressed_length, 1);
    // The spring to the peak, Eq. (58).
    if (found / peak_displacement > stiffness) {
        after.stiffness = found / peak_displacement;
        after.normal_stress = load.stressed_length > 0 ? load.normal_force / load.stressed_length : 0;
    }
    after.found_at_rest = load.at_rest ? 1 : 0;
    return after;
}

double PeakSpring::stiffness_of_part(double part) const {
    return length > 0 ? stiffness * std::min(part / length, 1.0) : 0;
}

}  // namespace rockslope::dda
