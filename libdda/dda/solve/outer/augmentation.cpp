#include "dda/solve/outer/augmentation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rockslope::dda {

namespace {

/// Whether an augmented contact violates the conditions of rigid contact by more than `tolerance`, m: it
/// bears a force but does not touch, penetrates, moves though locked, or slides against its shear force.
bool violates_rigid_contact(const ContactTrial& trial, const Forces& forces, double tolerance) {
    if (forces.normal > 0 && std::abs(trial.gap()) > tolerance) return true;
    if (trial.has_shear_spring) return std::abs(trial.shearing) > tolerance;
    return forces.shear != 0 && std::copysign(1.0, forces.shear) * trial.shearing < -tolerance;
}

}  // namespace

/// Shifts the springs as in Eq. (37).
bool augment(const StepProblem& problem, TrialContacts& trials, AndersonMixing& mixing) {
    const double tolerance = problem.model.penetration_tolerance;
    std::vector<ContactIndex> augmented;
    bool any = false;
    for (const ContactIndex k : problem.contacts.indices()) {
        if (!problem.model.is_augmented(problem.contacts[k].joint_material)) continue;
        augmented.push_back(k);
        any = any || violates_rigid_contact(trials[k], trials.law_forces(k), tolerance);
    }
    if (!any) return false;
    Eigen::VectorXd shift(2 * static_cast<Eigen::Index>(augmented.size()));
    Eigen::VectorXd force(shift.size());
    Eigen::Index row = 0;
    for (const ContactIndex k : augmented) {
        const Forces forces = trials.law_forces(k);
        shift[row] = trials[k].stress_free_gap * problem.springs[k].normal_stiffness;
        force[row++] = forces.normal;
        shift[row] = trials[k].shear_origin;
        force[row++] = forces.shear;
    }
    const Eigen::VectorXd next = mixing.next(shift, force);
    row = 0;
    for (const ContactIndex k : augmented) {
        trials[k].stress_free_gap = std::max(next[row++], 0.0) / problem.springs[k].normal_stiffness;
        trials[k].shear_origin = next[row++];
    }
    return true;
}

}  // namespace rockslope::dda
