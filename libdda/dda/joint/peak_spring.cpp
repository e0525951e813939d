#include "dda/joint/peak_spring.hpp"

#include <algorithm>

namespace dda {

PeakSpring PeakSpring::pressed(const Press& press, const BartonStrength& barton,
                               double peak_displacement) const {
    if (!(press.normal_force > 0) || !(press.length > 0) || !(peak_displacement > 0)) return *this;
    PeakSpring after = *this;
    after.length = press.length;
    if (rested != 0 && !press.at_rest) return after;
    const double found = barton.shear_strength(press.normal_force, press.stressed_length, 1);
    after.stiffness = std::max(stiffness, found / peak_displacement);
    after.rested = press.at_rest ? 1 : 0;
    return after;
}

double PeakSpring::of_part(double part) const {
    return length > 0 ? stiffness * std::min(part / length, 1.0) : 0;
}

}  // namespace dda
