#include "dda/joint/velocity_weakening.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

namespace {
constexpr double largest_speed = 1e30;  ///< m/s, above any real speed; keeps a history finite
}

/// tan(phi) at a speed, Eq. (72).
double VelocityWeakening::friction(double v) const {
    const double peak = std::tan(friction_angle);
    if (v == 0) return peak;
    const double least = std::tan(residual_friction_angle);
    if (rate > 0) return std::max(peak - rate * std::log1p(v / speed), least);
    return least + (peak - least) * std::exp(-v / speed);
}

Strength VelocityWeakening::strength(const History& history, double normal_force, double,
                                     const ShearTrial&) const {
    const double bound = std::max(normal_force, 0.0) * friction(history.speed);
    return {bound, bound, 0};
}

Strength VelocityWeakening::strength_slope(const History& history, double normal_force, double) const {
    if (!(normal_force > 0)) return {};
    const double slope = friction(history.speed);
    return {slope, slope, 0};
}

VelocityWeakening::History VelocityWeakening::advance(const History&, const ContactMotion& motion) const {
    // The plastic slip contains the unloading of the spring when the strength falls, which is much larger
    // than the motion of the faces: the speed is taken from the displacement.
    if (motion.time.is_static() || motion.slip == 0) return {};
    return {std::min(std::abs(motion.displacement) / motion.time.duration(), largest_speed)};
}

VelocityWeakening VelocityWeakening::read(const ParameterTable& table) {
    VelocityWeakening law;
    law.friction_angle = table.friction_angle("friction_angle");
    law.residual_friction_angle = table.residual_friction_angle(law.friction_angle);
    law.speed = table.positive("weakening_speed", Quantity::velocity);
    if (table.choice("weakening", {"exponential", "logarithmic"}) == "logarithmic")
        law.rate = table.positive("weakening_rate", Quantity::number);
    return law;
}

JointRecord VelocityWeakening::record(const History& history) const {
    const double least = std::tan(residual_friction_angle);
    const double range = std::tan(friction_angle) - least;
    JointRecord joint_record;
    joint_record.mobilised_ratio = range > 0 ? (friction(history.speed) - least) / range : 0;
    return joint_record;
}

}  // namespace rockslope::dda
