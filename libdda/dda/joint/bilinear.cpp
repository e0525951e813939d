#include "dda/joint/bilinear.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

Strength Bilinear::strength(const History& history, double normal_force, double length,
                            const ShearTrial&) const {
    const double compression = std::max(normal_force, 0.0);
    const double toothed = history.sheared_off ? 0.0 : std::min(compression, transition_stress * length);
    // The two lines of Eq. (69).
    const double shear =
        toothed * std::tan(friction_angle) + (compression - toothed) * std::tan(residual_friction_angle);
    return {shear, shear, 0};
}

Strength Bilinear::strength_slope(const History& history, double normal_force, double length) const {
    if (!(normal_force > 0)) return {};
    const bool toothed = !history.sheared_off && normal_force < transition_stress * length;
    const double slope = std::tan(toothed ? friction_angle : residual_friction_angle);
    return {slope, slope, 0};
}

Bilinear::History Bilinear::advance(const History& history, const ContactMotion& motion) const {
    const bool above = motion.normal_force > transition_stress * motion.length;
    return {history.sheared_off || (motion.slip != 0 && above)};
}

Bilinear Bilinear::read(const ParameterTable& table) {
    Bilinear law;
    law.friction_angle = table.friction_angle("friction_angle");
    law.residual_friction_angle = table.residual_friction_angle(law.friction_angle);
    law.transition_stress = table.not_negative("transition_stress", Quantity::stress, 0);
    return law;
}

}  // namespace rockslope::dda
