#include "dda/joint/weakening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

Weakening::History Weakening::fresh(bool intact) const {
    return {intact ? 0 : std::numeric_limits<double>::max()};
}

/// Fraction of the difference between peak and residual strength that is left after the slip u, m.
double Weakening::remaining_fraction(double u) const {
    return exponential ? std::exp(-u / slip) : std::max(1 - u / slip, 0.0);
}

/// The strength after a slip, Eq. (68).
double Weakening::bound(double u, double normal_force, double length) const {
    const double residual =
        CoulombLine{std::tan(residual_friction_angle), residual_cohesion}.strength(normal_force, length);
    const double peak = CoulombLine{std::tan(friction_angle), cohesion}.strength(normal_force, length);
    return residual + (peak - residual) * remaining_fraction(u);
}

double Weakening::bound_slope(double u, double normal_force, double length) const {
    const double lost =
        bound(0, normal_force, length) - bound(std::numeric_limits<double>::max(), normal_force, length);
    if (exponential) return -lost * remaining_fraction(u) / slip;
    return u < slip ? -lost / slip : 0;
}

Strength Weakening::strength(const History& history, double normal_force, double length,
                             const ShearTrial& trial) const {
    const double now = bound(history.slip, normal_force, length);
    const double elastic = std::abs(trial.shear_force + trial.stiffness * trial.displacement);
    if (!(elastic > now) || !(trial.stiffness > 0)) return {now, now, 0};
    // The slip u satisfies k u + bound(U + u) = elastic force. The left side is convex and below the right
    // one at u = 0: it has one positive root, to which Newton's iteration from above converges monotonically.
    const double least = bound(std::numeric_limits<double>::max(), normal_force, length);
    double u = (elastic - least) / trial.stiffness;
    for (int k = 0; k < 100; ++k) {
        const double at = history.slip + u;
        const double excess = trial.stiffness * u + bound(at, normal_force, length) - elastic;
        const double slope = trial.stiffness + bound_slope(at, normal_force, length);
        const double next = u - excess / slope;
        if (!(excess > 0) || !(slope > 0) || !(next < u)) break;
        u = next;
    }
    const double end_force = elastic - trial.stiffness * std::max(u, 0.0);
    const bool forward = trial.shear_force + trial.stiffness * trial.displacement > 0;
    return {forward ? end_force : now, forward ? now : end_force, 0};
}

Strength Weakening::strength_slope(const History& history, double normal_force, double) const {
    if (!(normal_force > 0)) return {};
    const double residual = std::tan(residual_friction_angle);
    const double slope = residual + (std::tan(friction_angle) - residual) * remaining_fraction(history.slip);
    return {slope, slope, 0};
}

Weakening Weakening::read(const ParameterTable& table) {
    Weakening law;
    law.friction_angle = table.friction_angle("friction_angle");
    law.residual_friction_angle = table.residual_friction_angle(law.friction_angle);
    law.cohesion = table.not_negative("cohesion", Quantity::stress, 0);
    law.residual_cohesion = table.checked(
        "residual_cohesion", table.not_negative("residual_cohesion", Quantity::stress, 0),
        [&](double v) { return v <= law.cohesion; }, "a stress up to 'cohesion'");
    law.slip = table.positive("weakening_slip", Quantity::length);
    law.exponential = table.choice("weakening", {"linear", "exponential"}) == "exponential";
    return law;
}

Weakening::History Weakening::advance(const History& history, const ContactMotion& motion) const {
    return {std::min(history.slip + std::abs(motion.slip), std::numeric_limits<double>::max())};
}

}  // namespace rockslope::dda
