#include "dda/joint/asperity_wear.hpp"

#include <algorithm>
#include <cmath>

namespace dda {

double AsperitySurface::angle(double work) const {
    double sum = 0;
    for (const Order& order : orders) sum += order.angle * std::exp(-order.wear * work);
    return sum;
}

namespace {

/// Sliding is integrated in steps over which wear times work grows by this while the asperities are whole:
/// the error of fourth order is then below 1e-13 of their angle. As they go the steps may grow.
constexpr double first_wear_in_a_step = 5e-3;
/// Pa; a stress beyond any that a model can have, for contacts next to no length.
constexpr double largest_stress = 1e30;

/// A displacement of such a joint under one normal force.
class AsperityWalk {
  public:
    AsperityWalk(const AsperitySurface& surface, const AsperityHistory& history, double normal_force,
                 double length, double stiffness, double shear_force)
        : surface_(surface),
          history_(history),
          normal_force_(normal_force),
          length_(length),
          stiffness_(stiffness),
          force_(shear_force) {}

    void go(double displacement, double told_slip) {
        const double target = history_.position + displacement;
        direction_ = displacement < 0 ? -1 : 1;
        while (history_.position != target) {
            const bool away = history_.position * direction_ >= 0;
            const double end = !away && target * direction_ > 0 ? 0 : target;
            cross(std::abs(end - history_.position), away, told_slip != 0);
            history_.position = end;
        }
        if (!(stiffness_ > 0)) return;
        for (const int direction : {1, -1}) {  // a strength that has come down on a force at rest
            const double excess = direction * force_ - bound(direction);
            if (!(excess > 1e-14 * std::abs(force_))) continue;
            force_ = direction * bound(direction);
            history_.work += work_rate(bound(direction)) * excess / stiffness_;
        }
    }

    double bound(int direction) const { return bound_of(history_.work, history_.position * direction >= 0); }
    const AsperityHistory& history() const { return history_; }
    double shear_force() const { return force_; }
    bool slipped() const { return slipped_; }

  private:
    struct Worn {
        double work;
        double dilation;
    };

    double bound_of(double work, bool away) const {
        const double asperity = surface_.angle(work);
        const double angle = surface_.friction_angle + (away ? asperity : -asperity);
        return normal_force_ * std::tan(std::max(angle, 0.0));
    }
    /// J/m2 per m of slip; a bare corner has no area to wear.
    double work_rate(double shear_force) const {
        return length_ > 0 ? std::min(shear_force / length_, largest_stress) : 0;
    }

    Worn rate(const Worn& at, bool away) const {
        const double slope = std::tan(surface_.angle(at.work));
        return {work_rate(bound_of(at.work, away)), away ? slope : -slope};
    }
    /// Runge and Kutta's step of fourth order over a slip.
    Worn after(const Worn& at, double slip, bool away) const {
        const auto ahead = [&](const Worn& rates, double part) {
            return Worn{at.work + part * rates.work, at.dilation + part * rates.dilation};
        };
        const Worn first = rate(at, away);
        const Worn second = rate(ahead(first, slip / 2), away);
        const Worn third = rate(ahead(second, slip / 2), away);
        const Worn fourth = rate(ahead(third, slip), away);
        const auto mean = [](double a, double b, double c, double d) { return (a + 2 * b + 2 * c + d) / 6; };
        return {at.work + slip * mean(first.work, second.work, third.work, fourth.work),
                at.dilation + slip * mean(first.dilation, second.dilation, third.dilation, fourth.dilation)};
    }

    /// The way on one side of the origin in one direction.
    void cross(double way, bool away, bool told_sliding) {
        if (!(stiffness_ > 0)) {
            if (told_sliding) slide_by(way, away);
            return;
        }
        const double bound = bound_of(history_.work, away);
        const double force = direction_ * force_;
        const double locked = std::clamp((bound - force) / stiffness_, 0.0, way);
        if (locked == way && force + stiffness_ * way <= bound) {
            force_ += direction_ * stiffness_ * way;
            return;
        }
        slide_to(way - locked, std::max(bound, force), away);
    }

    void slide_by(double slip, bool away) {
        slipped_ = true;
        while (slip > 0) {
            const double step = std::min(slip, largest_step(away));
            take(after(present(), step, away));
            slip -= step;
        }
    }

    /// Slides until the slip and what the spring gives with the strength, together, are the way. The spring
    /// gives back where the joint weakens.
    void slide_to(double way, double start, bool away) {
        slipped_ = true;
        double slip = 0;
        const auto reached = [&](double more, const Worn& worn) {
            return slip + more + (bound_of(worn.work, away) - start) / stiffness_;
        };
        for (;;) {
            const double missing = way - reached(0, present());
            double step = largest_step(away);
            if (missing > 0) step = std::min(step, 2 * missing);
            const Worn next = after(present(), step, away);
            if (reached(step, next) < way) {
                take(next);
                slip += step;
                continue;
            }
            double low = 0, high = step;
            for (int k = 0; k < 200 && high - low > 1e-16 * way; ++k) {
                const double below = reached(low, after(present(), low, away)) - way;
                const double above = reached(high, after(present(), high, away)) - way;
                double middle = low - below * (high - low) / (above - below);
                if (k % 3 == 2 || !(middle > low && middle < high)) middle = (low + high) / 2;
                if (!(middle > low && middle < high)) break;
                (reached(middle, after(present(), middle, away)) < way ? low : high) = middle;
            }
            take(after(present(), high, away));
            break;
        }
        force_ = direction_ * bound_of(history_.work, away);
    }

    double largest_step(bool away) const {
        const double rate = work_rate(bound_of(history_.work, away));
        double step = 1e300;
        for (const AsperitySurface::Order& order : surface_.orders) {
            const double worn = order.wear * history_.work;
            if (order.angle > 0 && order.wear * rate > 0 && worn < 40)
                step = std::min(step, first_wear_in_a_step * std::exp(worn / 5) / (order.wear * rate));
        }
        return step;
    }

    Worn present() const { return {history_.work, history_.dilation}; }
    void take(const Worn& worn) {
        history_.work = worn.work;
        history_.dilation = worn.dilation;
    }

    const AsperitySurface& surface_;
    AsperityHistory history_;
    double normal_force_, length_, stiffness_, force_;
    int direction_ = 1;
    bool slipped_ = false;
};

}  // namespace

Strength asperity_strength(const AsperitySurface& surface, const AsperityHistory& history,
                           double normal_force, double length, const ShearTrial& trial) {
    if (!(normal_force > 0)) return {};
    AsperityWalk walk(surface, history, normal_force, length, trial.stiffness, trial.shear_force);
    walk.go(trial.displacement, 0);
    Strength strength = {walk.bound(1), walk.bound(-1), 0};
    // What slipped back to the origin arrives with less than the strength beyond it.
    if (walk.slipped()) {
        double& ahead = trial.displacement > 0 ? strength.forward : strength.backward;
        ahead = std::min(ahead, std::abs(walk.shear_force()));
    }
    return strength;
}

Strength asperity_slope(const AsperitySurface& surface, const AsperityHistory& history, double normal_force) {
    if (!(normal_force > 0)) return {};
    const double asperity = surface.angle(history.work);
    const auto slope = [&](int direction) {
        const bool away = history.position * direction >= 0;
        return std::tan(std::max(surface.friction_angle + (away ? asperity : -asperity), 0.0));
    };
    return {slope(1), slope(-1), 0};
}

AsperityHistory asperity_advance(const AsperitySurface& surface, const AsperityHistory& history,
                                 const ContactMotion& motion) {
    if (!(motion.normal_force > 0)) return history;
    AsperityWalk walk(surface, history, motion.normal_force, motion.length, motion.stiffness,
                      motion.shear_force);
    walk.go(motion.displacement, motion.slip);
    return walk.history();
}

}  // namespace dda
