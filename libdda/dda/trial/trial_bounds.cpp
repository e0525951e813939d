// The shear bounds of the contacts in a step, and the bonds that break.

#include <algorithm>
#include <cmath>

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

namespace {

/// Force change over the force tolerance below which the law of a rough joint segment is not evaluated again.
/// The final convergence test evaluates all laws.
constexpr double law_reuse_tolerance = 0.1;

}  // namespace

Strength TrialContacts::bounds_of_single_contact(ContactIndex k, const ContactLoading& loading) const {
    const ContactMotion motion = contact_motion(p_.model, p_.contacts[k], p_.springs[k].shear_stiffness,
                                                loading.normal, loading.shearing, 0);
    const Strength strengths = strength(law_of(k), p_.contacts[k].history, motion.normal_force, motion.length,
                                        {motion.displacement, motion.shear_force, motion.stiffness});
    const double reduced = 1 / p_.model.strength_reduction;
    const Strength bounds{strengths.forward * reduced, strengths.backward * reduced,
                          strengths.tensile * reduced};
    if (!p_.bonds_hold() || p_.held_shares[k] == 1) return bounds;
    const Strength bond = strength(law_of(k), p_.contacts[k].history, 0, motion.length);
    const double not_held = (1 - p_.held_shares[k]) * reduced;
    return {std::max(bounds.forward - not_held * bond.forward, 0.0),
            std::max(bounds.backward - not_held * bond.backward, 0.0), p_.held_shares[k] * bounds.tensile};
}

/// The bounds of Eq. (75).
Strength TrialContacts::bounds_at(ContactIndex k, const ContactLoading& here) const {
    if (is_bonded(k)) return bounds_of_single_contact(k, here);
    if (!(here.normal > 0) && !coheres(k)) return {};
    Strength bounds = bounds_of_single_contact(k, {std::max(here.normal, 0.0), here.shearing});
    if (has_cohesion(k) && !coheres(k)) {
        const Strength cohesion = bounds_of_single_contact(k, {0, here.shearing});
        bounds.forward = std::max(bounds.forward - cohesion.forward, 0.0);
        bounds.backward = std::max(bounds.backward - cohesion.backward, 0.0);
    }
    return bounds;
}

void TrialContacts::find_requested_lines() {
    segment_friction_.find_requested_lines(
        [this](ContactIndex k) { return evaluated_ ? current_loading(k) : initial_loading(k); });
}

void TrialContacts::set_bound_to_friction_force(ContactIndex k, double normal_force) {
    Trial& trial = trials_[k];
    trial.held_normal = std::max(normal_force, 0.0);
    (trial.forward ? trial.bounds.forward : trial.bounds.backward) =
        std::abs(trial.friction_force + trial.tilt * trial.held_normal);
}

double TrialContacts::bound_at(ContactIndex k, double normal, RowSpan<const Vec6> d) const {
    const ContactSprings& s = p_.springs[k];
    return in_direction(k, bounds_of_single_contact(k, {normal, s.rows.measure(s.shear, d)}));
}

void TrialContacts::update_bounds() {
    compute_bounds(law_reuse_tolerance * tolerance());
}

void TrialContacts::update_all_bounds() {
    compute_bounds(0);
}

void TrialContacts::compute_bounds(double change_tolerance) {
    for_contacts([&](ContactIndex k) {
        Trial& trial = trials_[k];
        if (!trial.may_close) {
            if (!is_on_segment(k)) trial.bounds = {};
            return;
        }
        const ContactLoading here = current_loading(k);
        if (!is_on_segment(k)) trial.bounds = bounds_at(k, here);
        // The tension that a bond bears is one of the bounds.
        trial.held_normal = is_bonded(k) ? current_loading(k).normal : here.normal;
    });
    segment_friction_.update(
        change_tolerance, [this](ContactIndex k) { return current_loading(k); },
        [this](ContactIndex k, const Strength& bounds) { trials_[k].bounds = bounds; });
}

Eigen::VectorXd TrialContacts::shear_bounds() const {
    Eigen::VectorXd shear_bounds(static_cast<Eigen::Index>(2 * trials_.size()));
    Eigen::Index row = 0;
    for (const Trial& trial : trials_) {
        shear_bounds[row++] = trial.bounds.forward;
        shear_bounds[row++] = trial.bounds.backward;
    }
    return shear_bounds;
}

void TrialContacts::set_shear_bounds(const Eigen::VectorXd& shear_bounds) {
    Eigen::Index row = 0;
    for (Trial& trial : trials_) {
        trial.bounds.forward = std::max(shear_bounds[row++], 0.0);
        trial.bounds.backward = std::max(shear_bounds[row++], 0.0);
    }
}

bool TrialContacts::break_bonds() {
    if (p_.bonds_hold()) return false;
    return for_any_contact([&](ContactIndex k) {
        const bool breaks = is_bonded(k) && current_forces(k).normal < -trials_[k].bounds.tensile;
        trials_[k].bond_broken = trials_[k].bond_broken || breaks;
        return breaks;
    });
}

}  // namespace rockslope::dda
