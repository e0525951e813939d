#include "dda/joint/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

Strength MohrCoulomb::strength(const History& history, double normal_force, double length) const {
    const double compression = std::max(normal_force, 0.0);
    if (history.broken) {
        const double shear = compression * std::tan(residual_friction_angle) + residual_cohesion * length;
        return {shear, shear, 0};
    }
    // An intact joint in tension keeps its cohesion and loses the friction of the missing compression.
    const double shear = std::max(normal_force * std::tan(friction_angle) + cohesion * length, 0.0);
    return {shear, shear, tensile_strength * length};
}

Strength MohrCoulomb::strength_slope(const History& history, double normal_force, double length) const {
    if (history.broken) {
        const double slope = normal_force > 0 ? std::tan(residual_friction_angle) : 0;
        return {slope, slope, 0};
    }
    const double friction = std::tan(friction_angle);
    const double slope = normal_force * friction + cohesion * length > 0 ? friction : 0;
    return {slope, slope, 0};
}

MohrCoulomb::History MohrCoulomb::advance(const History& history, const ContactMotion& motion) const {
    return {history.broken || motion.opened || motion.slip != 0};
}

}  // namespace rockslope::dda
