#include "dda/joint/peak_spring.hpp"

#include <algorithm>

namespace dda {

PeakSpring PeakSpring::pressed(const BartonStrength& barton, double normal_force, double length_now,
                               double stressed_length, double peak_displacement) const {
    if (!(normal_force > 0) || !(length_now > 0) || !(peak_displacement > 0)) return *this;
    const double found = barton.shear_strength(normal_force, stressed_length, 1) / peak_displacement;
    return {std::max(stiffness, found), length_now};
}

double PeakSpring::of_part(double part) const {
    return length > 0 ? stiffness * std::min(part / length, 1.0) : 0;
}

}  // namespace dda
