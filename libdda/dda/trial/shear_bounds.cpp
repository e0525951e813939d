#include "dda/trial/shear_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "dda/trial/single_strength.hpp"

namespace rockslope::dda {

namespace {

/// Force change over the force tolerance below which the law of a rough joint segment is not evaluated again.
/// The final convergence test evaluates all laws.
constexpr double law_reuse_tolerance = 0.1;
/// Least and largest hardening over the stiffness of the shear spring. Beside blocks that hardly resist, a
/// small hardening decides how far a joint slides: without those below 0.03, slopes with
/// 'continuously-yielding' joints do not settle.
constexpr double least_hardening = 0.001;
constexpr double largest_hardening = 0.9;

/// A hardening, N/m per metre, as a power of two of the stiffness: the matrix seldom changes by it then.
double rounded_hardening(double hardening, double stiffness) {
    const double part = hardening / stiffness;
    if (!(part > least_hardening)) return 0;
    return std::min(std::exp2(std::round(std::log2(part))), largest_hardening) * stiffness;
}

}  // namespace

ShearBounds::ShearBounds(const StepProblem& problem, TrialContacts& trials, const ThreadPool& pool)
    : p_(problem), trials_(trials), segments_(problem, pool) {
    trials_.for_each([&](ContactIndex k) {
        ContactTrial& trial = trials_[k];
        if (trial.has_normal_spring && !trial.has_shear_spring && !is_on_segment(k))
            trial.bounds = single_strength(p_, k, trials_.loading(k));
    });
}

/// The bounds of Eq. (75).
Strength ShearBounds::bounds_at(ContactIndex k, const ContactLoading& here) const {
    if (trials_.is_bonded(k)) return single_strength(p_, k, here);
    if (!(here.normal > 0) && !trials_.coheres(k)) return {};
    Strength bounds = single_strength(p_, k, {std::max(here.normal, 0.0), here.shearing});
    if (trials_[k].has_cohesion && !trials_.coheres(k)) {
        const Strength cohesion = single_strength(p_, k, {0, here.shearing});
        bounds.forward = std::max(bounds.forward - cohesion.forward, 0.0);
        bounds.backward = std::max(bounds.backward - cohesion.backward, 0.0);
    }
    return bounds;
}

void ShearBounds::update() {
    compute(law_reuse_tolerance * trials_.tolerance());
}

void ShearBounds::compute(double change_tolerance) {
    trials_.for_each([&](ContactIndex k) {
        ContactTrial& trial = trials_[k];
        if (!trial.may_close) {
            if (!is_on_segment(k)) trial.bounds = {};
            return;
        }
        const ContactLoading here = trials_.loading(k);
        if (!is_on_segment(k)) trial.bounds = bounds_at(k, here);
        // The tension that a bond bears is one of the bounds.
        trial.held_normal = trials_.is_bonded(k) ? trials_.loading(k).normal : here.normal;
    });
    segments_.update(
        change_tolerance, [this](ContactIndex k) { return trials_.loading(k); },
        [this](ContactIndex k, const Strength& bounds, const Hardening& by_law) {
            const double stiffness = p_.springs[k].shear_stiffness;
            const Hardening rounded{rounded_hardening(by_law.forward, stiffness),
                                    rounded_hardening(by_law.backward, stiffness)};
            trials_[k].set_bounds(bounds, holds_hardening_ ? trials_[k].hardening : rounded);
        });
}

Eigen::VectorXd ShearBounds::values() const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(2 * trials_.count()));
    Eigen::Index row = 0;
    for (const ContactIndex k : p_.contacts.indices()) {
        const ContactTrial& trial = trials_[k];
        values[row++] = trial.bounds.forward - trial.hardening.forward * trial.held_shearing;
        values[row++] = trial.bounds.backward + trial.hardening.backward * trial.held_shearing;
    }
    return values;
}

void ShearBounds::set_values(const Eigen::VectorXd& values) {
    Eigen::Index row = 0;
    for (const ContactIndex k : p_.contacts.indices()) {
        ContactTrial& trial = trials_[k];
        trial.bounds.forward = std::max(values[row++] + trial.hardening.forward * trial.held_shearing, 0.0);
        trial.bounds.backward = std::max(values[row++] - trial.hardening.backward * trial.held_shearing, 0.0);
    }
}

Strength ShearBounds::over_normal_force(ContactIndex k) const {
    const ContactTrial& trial = trials_[k];
    if (!(trial.held_normal > 0)) return {};
    return {trial.bounds.forward / trial.held_normal, trial.bounds.backward / trial.held_normal, 0};
}

double ShearBounds::bound_at(ContactIndex k, double normal, RowSpan<const Vec6> d) const {
    const ContactSprings& s = p_.springs[k];
    const Strength bounds = bounds_at(k, {normal, s.rows.measure(s.shear, d)});
    return trials_[k].slides_forward ? bounds.forward : bounds.backward;
}

ShearLine ShearBounds::line(ContactIndex k, double normal, RowSpan<const Vec6> d) const {
    const Contact& contact = p_.contacts[k];
    const bool bonded = trials_.is_bonded(k);
    const bool coheres = trials_.coheres(k);
    ShearLine line;
    if (const auto of_law = bound_line(trials_.law_of(k), contact.history)) {
        const double reduced = 1 / p_.model.strength_reduction;
        const double held = p_.bonds_hold() ? p_.held_shares[k] * reduced : reduced;
        line.slope = reduced * of_law->friction;
        line.cohesion = coheres || bonded ? held * of_law->cohesion * contact.length : 0;
        line.lowest_normal_force = trials_.least_normal_force(k);
        return line;
    }
    const double at_iterate = trials_.law_forces(k).normal;
    if (is_on_segment(k)) return segments_.line(k, trials_[k].slides_forward, at_iterate);
    if (!(normal > 0) && !bonded && !coheres) {
        line.slope = at_iterate > 0 ? trials_[k].bound() / at_iterate : 0;
        return line;
    }
    line.cohesion = bound_at(k, normal, d);
    if (!(normal > 0)) return line;
    const double half = normal / 2;
    line.slope = (line.cohesion - bound_at(k, half, d)) / half;
    line.cohesion -= line.slope * normal;
    return line;
}

}  // namespace rockslope::dda
