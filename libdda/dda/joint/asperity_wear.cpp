#include "dda/joint/asperity_wear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dda/joint/parameter_table.hpp"

namespace rockslope::dda {

double AsperitySurface::angle(double work) const {
    double sum = 0;
    for (const Order& order : orders) sum += order.angle * std::exp(-order.wear * work);
    return sum;
}

namespace {

/// Increase of wear times work in one integration step while the asperities are unworn: the error of fourth
/// order is then below 1e-13 of their angle. The steps grow as the asperities wear.
constexpr double initial_wear_per_step = 5e-3;
/// Pa, upper limit of the stress, for contacts with a length near zero.
constexpr double largest_stress = 1e30;

/// Force beyond the strength of the return, over the strength away from the origin, that is more than
/// rounding.
constexpr double crossing_tolerance = 1e-9;

/// What the joint can bear, and what a slip changes, Eq. (70).
struct Bound {
    double value = 0;      ///< N per metre
    double slope = 0;      ///< of the value by the work, m
    double asperity = 0;   ///< the angle of the asperities, rad
    double work_rate = 0;  ///< J/m2 per m of slip
};

/// The strength of Eq. (70) on the side of the asperities that slip climbs (`away` from the origin) or
/// descends.
Bound bound_at(const AsperitySurface& surface, double work, bool away, double normal_force, double length) {
    Bound bound;
    double decay = 0;
    for (const AsperitySurface::Order& order : surface.orders) {
        if (order.angle == 0) continue;
        const double left = order.angle * std::exp(-order.wear * work);
        bound.asperity += left;
        decay += order.wear * left;
    }
    const double angle = surface.friction_angle + (away ? bound.asperity : -bound.asperity);
    if (!(angle > 0)) return bound;
    const double tangent = std::tan(angle);
    bound.value = normal_force * tangent;
    bound.slope = normal_force * (1 + tangent * tangent) * (away ? -decay : decay);
    bound.work_rate =
        length > 0 ? std::min(bound.value / length, largest_stress) : 0;  // a vertex has no area
    return bound;
}

/// Integrates a displacement of such a joint under one normal force; the dilation only if `dilates`.
class AsperityShearPath {
  public:
    AsperityShearPath(const AsperitySurface& surface, const AsperityHistory& history, double normal_force,
                      double length, const ShearSpring& spring, bool dilates)
        : surface_(surface),
          history_(history),
          normal_force_(normal_force),
          length_(length),
          stiffness_(spring.stiffness),
          force_(spring.force),
          dilates_(dilates) {}

    void displace(double displacement, double prescribed_slip) {
        const double target = history_.position + displacement;
        direction_ = displacement < 0 ? -1 : 1;
        while (history_.position != target) {
            if (history_.position == 0) cross_origin();
            const bool away = history_.position * direction_ >= 0;
            const double end = !away && target * direction_ > 0 ? 0 : target;
            traverse(std::abs(end - history_.position), away, prescribed_slip != 0);
            history_.position = end;
        }
        if (!(stiffness_ > 0)) return;
        if (force_ != 0) relax_to_bound(force_ > 0 ? 1 : -1);
        const int held = static_cast<int>(history_.crossed);
        if (held != 0 && !(bound(held).value > bound_of(history_.work, false).value)) history_.crossed = 0;
    }

    /// The strength against slip in a direction, where the joint is now.
    Bound bound(int direction) const {
        const bool away = history_.position * direction >= 0;
        Bound here = bound_of(history_.work, away);
        if (away || history_.crossed != direction) return here;
        // What is left of the strength at the origin, Eq. (82).
        Bound held = bound_of(history_.work, true);
        held.value -= stiffness_ * std::abs(history_.position);
        if (!(held.value > here.value)) return here;
        held.work_rate = length_ > 0 ? std::min(held.value / length_, largest_stress) : 0;
        return held;
    }
    const AsperityHistory& history() const { return history_; }
    double shear_force() const { return force_; }
    bool slipped() const { return slipped_; }

  private:
    struct WearState {
        double work;
        double dilation;
    };

    Bound bound_of(double work, bool away) const {
        return bound_at(surface_, work, away, normal_force_, length_);
    }

    /// Marks a locked joint whose force is beyond the strength that it would return with, once it has passed
    /// the origin.
    void cross_origin() {
        history_.crossed = 0;
        if (!(direction_ * force_ < 0) || !(stiffness_ > 0)) return;
        const double excess = std::abs(force_) - bound_of(history_.work, false).value;
        if (excess > crossing_tolerance * bound_of(history_.work, true).value) history_.crossed = -direction_;
    }

    /// Slips until the force equals a strength that has fallen below it.
    void relax_to_bound(int direction) {
        const Bound now = bound(direction);
        const double excess = direction * force_ - now.value;
        if (!(excess > 1e-14 * std::abs(force_))) return;
        force_ = direction * now.value;
        history_.work += now.work_rate * excess / stiffness_;
    }

    WearState rate(const Bound& at, bool away) const {
        const double slope = dilates_ ? std::tan(at.asperity) : 0;
        return {at.work_rate, away ? slope : -slope};
    }
    /// Runge-Kutta step of fourth order over a slip. @param at the bound at its start.
    WearState runge_kutta_step(const Bound& at, double slip, bool away) const {
        const WearState first = rate(at, away);
        const auto ahead = [&](const WearState& rates, double part) {
            return rate(bound_of(history_.work + part * rates.work, away), away);
        };
        const WearState second = ahead(first, slip / 2);
        const WearState third = ahead(second, slip / 2);
        const WearState fourth = ahead(third, slip);
        const auto mean = [](double a, double b, double c, double d) { return (a + 2 * b + 2 * c + d) / 6; };
        return {history_.work + slip * mean(first.work, second.work, third.work, fourth.work),
                history_.dilation +
                    slip * mean(first.dilation, second.dilation, third.dilation, fourth.dilation)};
    }

    /// The displacement on one side of the origin in one direction.
    void traverse(double displacement, bool away, bool sliding_prescribed) {
        if (!(stiffness_ > 0)) {
            if (sliding_prescribed) slide_prescribed(displacement, away);
            return;
        }
        const Bound bound = bound_of(history_.work, away);
        if (!away && history_.crossed == direction_ && this->bound(direction_).value > bound.value) {
            // The strength grows with the spring's force, Eq. (82): the joint slips at once or not until the
            // origin.
            relax_to_bound(direction_);
            force_ += direction_ * stiffness_ * displacement;
            return;
        }
        const double force = direction_ * force_;
        const double locked = std::clamp((bound.value - force) / stiffness_, 0.0, displacement);
        if (locked == displacement && force + stiffness_ * displacement <= bound.value) {
            force_ += direction_ * stiffness_ * displacement;
            return;
        }
        slide_against_spring(
            displacement - locked + (std::max(bound.value, force) - bound.value) / stiffness_, bound, away);
    }

    void slide_prescribed(double slip, bool away) {
        slipped_ = true;
        while (slip > 0) {
            const Bound bound = bound_of(history_.work, away);
            const double step = std::min(slip, largest_step(bound));
            set_wear(runge_kutta_step(bound, step, away));
            slip -= step;
        }
    }

    /// Slides until slip plus change of the spring's length is the displacement. The spring unloads where the
    /// strength falls. @param bound at the start.
    void slide_against_spring(double displacement, Bound bound, bool away) {
        slipped_ = true;
        for (;;) {
            const double start = bound.value, most = largest_step(bound);
            double slip = most;
            const bool arrived = solve_slip(displacement, slip, bound, away);
            if (arrived) break;
            displacement -= slip + (bound.value - start) / stiffness_;
        }
        force_ = direction_ * bound.value;
    }

    /// Finds the slip that completes the displacement, by Newton's method within a bracket.
    /// @param slip the largest slip on entry, the slip on return; @param bound at the start on entry, at the
    /// end on return. @return false if the largest slip does not complete the displacement.
    bool solve_slip(double displacement, double& slip, Bound& bound, bool away) {
        const Bound start = bound;
        const double most = slip, rounding = 4e-16 * (displacement + start.value / stiffness_);
        if (displacement <= rounding) return true;
        double low = 0, high = most;
        bool bracketed = false;
        double guess = displacement / (1 + start.slope * start.work_rate / stiffness_);
        WearState worn{};
        for (int k = 0; k < 100; ++k) {
            const bool inside = guess > low && guess < high;
            if (!inside && bracketed && !(high - low > 1e-16 * high)) break;
            slip = inside ? guess : bracketed ? (low + high) / 2 : most;
            worn = runge_kutta_step(start, slip, away);
            bound = bound_of(worn.work, away);
            const double excess = slip + (bound.value - start.value) / stiffness_ - displacement;
            if (slip == most && excess < 0) {
                set_wear(worn);
                return false;
            }
            if (std::abs(excess) <= rounding) break;
            (excess < 0 ? low : high) = slip;
            bracketed = bracketed || excess > 0;
            guess = slip - excess / (1 + bound.slope * bound.work_rate / stiffness_);
        }
        set_wear(worn);
        return true;
    }

    double largest_step(const Bound& bound) const {
        double step = 1e300;
        for (const AsperitySurface::Order& order : surface_.orders) {
            const double wear = order.wear * bound.work_rate, worn = order.wear * history_.work;
            if (order.angle > 0 && wear > 0 && worn < 40)
                step = std::min(step, initial_wear_per_step * std::exp(worn / 5) / wear);
        }
        return step;
    }

    void set_wear(const WearState& worn) {
        history_.work = worn.work;
        history_.dilation = worn.dilation;
    }

    const AsperitySurface& surface_;
    AsperityHistory history_;
    double normal_force_, length_, stiffness_, force_;
    bool dilates_;
    int direction_ = 1;
    bool slipped_ = false;
};

}  // namespace

Strength asperity_strength(const AsperitySurface& surface, const AsperityHistory& history,
                           double normal_force, double length, const ShearTrial& trial) {
    if (!(normal_force > 0)) return {};
    AsperityShearPath path(surface, history, normal_force, length,
                           {.stiffness = trial.stiffness, .force = trial.shear_force}, false);
    path.displace(trial.displacement, 0);
    Strength strength = {path.bound(1).value, path.bound(-1).value, 0};
    // A joint that slipped back to the origin has a smaller force than the strength beyond it.
    if (path.slipped()) {
        double& ahead = trial.displacement > 0 ? strength.forward : strength.backward;
        ahead = std::min(ahead, std::abs(path.shear_force()));
    }
    return strength;
}

Strength asperity_strength_slope(const AsperitySurface& surface, const AsperityHistory& history,
                                 double normal_force) {
    if (!(normal_force > 0)) return {};
    const auto slope = [&](int direction) {
        const bool away = history.position * direction >= 0 || history.crossed == direction;
        const Bound bound = bound_at(surface, history.work, away, 1, 1);  // per N of normal force
        const double turn = (away ? bound.asperity : -bound.asperity) * surface.slope * normal_force;
        return bound.value > 0 ? bound.value + (1 + bound.value * bound.value) * turn : 0;
    };
    return {slope(1), slope(-1), 0};
}

double read_asperity_angle(const ParameterTable& table, const char* key, double below) {
    return table.checked(
        key, table.number(key, Quantity::angle),
        [below](double v) { return v >= 0 && v + below < std::numbers::pi / 2; },
        "an angle from 0 that leaves the sum with friction below 90 deg");
}

double read_asperity_wear(const ParameterTable& table, const char* key) {
    return table.not_negative(key, Quantity::number, 0);
}

AsperityHistory asperity_advance(const AsperitySurface& surface, const AsperityHistory& history,
                                 const ContactMotion& motion) {
    if (!std::isfinite(motion.displacement)) return history;  // of an iteration that diverges
    AsperityShearPath path(surface, history, motion.normal_force, motion.length,
                           {.stiffness = motion.stiffness, .force = motion.shear_force}, true);
    path.displace(motion.displacement, motion.slip);
    return path.history();
}

AsperityHistory asperity_flight(const AsperitySurface& surface, const AsperityHistory& history,
                                const ContactMotion& motion) {
    if (!std::isfinite(motion.displacement)) return history;  // of an iteration that diverges
    const auto flown = [&](const AsperityHistory& before, double displacement, double shear_force) {
        AsperityShearPath path(surface, before, 0, motion.length,
                               {.stiffness = motion.stiffness, .force = shear_force}, true);
        path.displace(displacement, displacement);
        AsperityHistory after = path.history();
        after.dilation = std::max(after.dilation, std::min(before.dilation, 0.0));
        return after;
    };
    const double beyond = history.position + motion.displacement;
    if (!(history.position * beyond < 0)) return flown(history, motion.displacement, motion.shear_force);
    // Back to the origin the asperities lower the wall, beyond it they lift it.
    return flown(flown(history, -history.position, motion.shear_force), beyond, 0);
}

}  // namespace rockslope::dda
