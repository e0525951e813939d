// Augmented contacts, whose springs are shifted until they are rigid.

#include <algorithm>
#include <cmath>

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

bool TrialContacts::violates_rigid_contact(ContactIndex k, double tolerance) const {
    const Trial& trial = trials_[k];
    const Forces forces = current_forces(k);
    if (forces.normal > 0 && std::abs(gap(k)) > tolerance) return true;
    if (trial.locked) return std::abs(trial.shearing) > tolerance;
    return forces.shear != 0 && std::copysign(1.0, forces.shear) * trial.shearing < -tolerance;
}

/// Shifts the springs as in Eq. (37).
bool TrialContacts::augment(AndersonMixing& mixing) {
    const double tolerance = p_.model.penetration_tolerance;
    std::vector<ContactIndex> augmented;
    bool any = false;
    for (const ContactIndex k : trials_.indices()) {
        if (!p_.model.is_augmented(p_.contacts[k].joint_material)) continue;
        augmented.push_back(k);
        any = any || violates_rigid_contact(k, tolerance);
    }
    if (!any) return false;
    Eigen::VectorXd shift(2 * static_cast<Eigen::Index>(augmented.size()));
    Eigen::VectorXd force(shift.size());
    Eigen::Index row = 0;
    for (const ContactIndex k : augmented) {
        const Forces forces = current_forces(k);
        shift[row] = trials_[k].stress_free_gap * p_.springs[k].normal_stiffness;
        force[row++] = forces.normal;
        shift[row] = trials_[k].shear_origin;
        force[row++] = forces.shear;
    }
    const Eigen::VectorXd next = mixing.next(shift, force);
    row = 0;
    for (const ContactIndex k : augmented) {
        trials_[k].stress_free_gap = std::max(next[row++], 0.0) / p_.springs[k].normal_stiffness;
        trials_[k].shear_origin = next[row++];
    }
    return true;
}

}  // namespace rockslope::dda
