#include "dda/joint/continuously_yielding.hpp"

#include <algorithm>
#include <cmath>

#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

namespace {

/// Upper limit of r; without it a joint that reverses at its bound would remain elastic.
constexpr double largest_unloading = 0.75;
/// Plastic displacement over roughness length above which the joint is fully worn.
constexpr double full_wear = 40;
/// Integration step over the approach length, and over the roughness length.
constexpr double fine_step = 0.02;
/// Roughness length over approach length above which the approach is integrated in closed form.
constexpr double stiff_ratio = 200;

/// Integrates a displacement of the joint in one direction under a constant normal force. Shear forces are
/// positive if they resist that direction.
class YieldingShearPath {
  public:
    YieldingShearPath(const ContinuouslyYielding& law, double plastic, double unloading, double normal_force,
                      double stiffness, double force)
        : law_(law),
          normal_force_(normal_force),
          stiffness_(stiffness),
          unloading_(unloading),
          force_(force),
          plastic_(plastic) {}

    double force() const { return force_; }
    double plastic() const { return plastic_; }
    bool yielded() const { return yielded_; }
    double bound() const { return bound_at(plastic_); }
    /// Strength in the other direction: a force that lags behind the bound there unloads elastically.
    double reverse_bound() const { return std::max(bound(), std::min(-force_, bound() + largest_lag())); }

    void displace(double displacement) {
        const double excess = force_ - bound() - largest_lag();
        if (excess > 0) {  // the normal force has fallen
            force_ -= excess;
            plastic_ += excess / stiffness_;
            yielded_ = true;
        }
        const double elastic = std::clamp((unloading_ * bound() - force_) / stiffness_, 0.0, displacement);
        force_ += stiffness_ * elastic;
        displacement -= elastic;
        yielded_ = yielded_ || displacement > 0;
        while (displacement > 0) displacement -= step(displacement);
    }

  private:
    double bound_at(double plastic) const {
        const double left = std::exp(-std::max(plastic, 0.0) / law_.roughness_length);
        const double angle =
            law_.residual_friction_angle + (law_.friction_angle - law_.residual_friction_angle) * left;
        return normal_force_ * std::tan(angle);
    }
    /// Largest lag of the force behind a falling bound under a constant normal force: the initial rate of the
    /// fall times the approach length.
    double largest_lag() const {
        const double tangent = std::tan(law_.friction_angle);
        const double fall = normal_force_ * (1 + tangent * tangent) *
                            (law_.friction_angle - law_.residual_friction_angle) / law_.roughness_length;
        return fall * approach_length(normal_force_ * tangent);
    }
    /// Displacement over which the distance of the force from the bound falls by a factor e, m.
    double approach_length(double bound) const { return bound * (1 - unloading_) / stiffness_; }

    /// One integration step of at most `displacement`. @return its length.
    double step(double displacement) {
        const double length = approach_length(bound());
        const double wear = plastic_ / law_.roughness_length;
        if (!(length > 0)) {  // no strength
            plastic_ += displacement;
            force_ = 0;
            return displacement;
        }
        if (wear > full_wear || law_.friction_angle == law_.residual_friction_angle)
            return ramp(displacement, bound(), bound());
        const double wearing = fine_step * law_.roughness_length * std::exp(wear / 5);
        if (law_.roughness_length > stiff_ratio * length) {
            const double h = std::min(displacement, wearing);
            return ramp(h, bound(), bound_at(plastic_ + h));
        }
        // Near the bound the solution is smooth for any approach length, and longer steps are accurate.
        const double far = std::abs(1 - force_ / bound());
        const double growth = std::clamp(std::pow(1e-3 / std::max(far, 1e-12), 0.2), 1.0, 20.0);
        return runge_kutta(std::min({displacement, fine_step * length * growth, wearing}));
    }

    /// Closed-form step for a bound that changes linearly from `first` to `last`.
    double ramp(double h, double first, double last) {
        const double length = approach_length((first + last) / 2);
        const double lag = (last - first) / h * length;
        const double after = last - lag + (force_ - first + lag) * std::exp(-h / length);
        plastic_ += std::max(h - (after - force_) / stiffness_, 0.0);
        force_ = after;
        return h;
    }

    /// Integrates Eqs. (73) and (74) over a displacement h.
    double runge_kutta(double h) {
        const auto elastic_share = [&](double force, double plastic) {
            return std::min((1 - force / bound_at(plastic)) / (1 - unloading_), 1.0);
        };
        const double a = elastic_share(force_, plastic_);
        const auto at = [&](double share, double part) {
            return elastic_share(force_ + part * h * stiffness_ * share, plastic_ + part * h * (1 - share));
        };
        const double b = at(a, 0.5), c = at(b, 0.5), d = at(c, 1);
        const double mean = (a + 2 * b + 2 * c + d) / 6;
        force_ += h * stiffness_ * mean;
        plastic_ += h * (1 - mean);
        return h;
    }

    const ContinuouslyYielding& law_;
    double normal_force_, stiffness_, unloading_;
    double force_, plastic_;
    bool yielded_ = false;
};

/// r for a displacement in a direction. @param force positive if it resists that direction.
double unloading_for(const ContinuouslyYielding::History& history, int direction, double force,
                     double bound) {
    if (direction == history.direction) return history.unloading;
    return bound > 0 ? std::clamp(force / bound, 0.0, largest_unloading) : 0;
}

}  // namespace

/// tan(phi_m) of Eq. (74).
double ContinuouslyYielding::bounding_tangent(double plastic) const {
    const double left = std::exp(-plastic / roughness_length);
    return std::tan(residual_friction_angle + (friction_angle - residual_friction_angle) * left);
}

Strength ContinuouslyYielding::strength(const History& history, double normal_force, double,
                                        const ShearTrial& trial) const {
    if (!(normal_force > 0)) return {};
    const int direction = sign_of(trial.displacement);
    if (direction == 0 || !(trial.stiffness > 0)) {
        const double plastic = history.plastic + (direction == 0 ? 0 : std::abs(trial.displacement));
        const double bound = normal_force * bounding_tangent(plastic);
        return {bound, bound, 0};
    }
    const double force = direction * trial.shear_force;
    const double bound = normal_force * bounding_tangent(history.plastic);
    YieldingShearPath joint(*this, history.plastic, unloading_for(history, direction, force, bound),
                            normal_force, trial.stiffness, force);
    joint.displace(std::abs(trial.displacement));
    const double against = joint.reverse_bound();
    const double along = joint.yielded() ? std::max(joint.force(), 0.0) : against;
    return direction > 0 ? Strength{along, against, 0} : Strength{against, along, 0};
}

ContinuouslyYielding::History ContinuouslyYielding::advance(const History& history,
                                                            const ContactMotion& motion) const {
    const int direction = sign_of(motion.displacement);
    if (direction == 0) return history;
    const double force = direction * motion.shear_force;
    const double bound = motion.normal_force * bounding_tangent(history.plastic);
    const double unloading = unloading_for(history, direction, force, bound);
    if (!(motion.stiffness > 0)) return {history.plastic + std::abs(motion.slip), unloading, direction};
    YieldingShearPath joint(*this, history.plastic, unloading, motion.normal_force, motion.stiffness, force);
    joint.displace(std::abs(motion.displacement));
    return {joint.plastic(), unloading, direction};
}

ContinuouslyYielding ContinuouslyYielding::read(const ParameterTable& table) {
    ContinuouslyYielding law;
    law.friction_angle = table.friction_angle("friction_angle");
    law.residual_friction_angle = table.residual_friction_angle(law.friction_angle);
    law.roughness_length = table.positive("roughness_length", Quantity::length);
    return law;
}

JointRecord ContinuouslyYielding::record(const History& history) const {
    JointRecord joint_record;
    if (friction_angle > residual_friction_angle)
        joint_record.mobilised_ratio = std::exp(-history.plastic / roughness_length);
    return joint_record;
}

}  // namespace rockslope::dda
