#pragma once

#include "dda/contact/contact_stiffness.hpp"

namespace rockslope::dda {

/// The shear force of a contact and what opens its joint.
struct ShearedContact {
    double shear_force = 0;   ///< N per metre
    double normal_force = 0;  ///< N per metre
    double dilation = 0;      ///< m
    double joint_share = 1;   ///< its part in the normal force of its joint segment, Eq. (81)

    /// The force f of the shear spring, Eq. (77), N per metre. @param dilating the locked dilation of the
    /// contact's history.
    double spring_force(const LockedDilation& dilating) const {
        return dilating.slope == 0 ? shear_force
                                   : shear_force - dilating.shear_force(normal_force, joint_share);
    }
};

/// A contact at the start or the end of a step.
inline ShearedContact sheared(const Contact& contact) {
    return {contact.shear_force, contact.normal_force, contact.dilation, contact.joint_share};
}

/// Energy of a contact's shear spring, and of the dilation of a joint that has not slipped, Eq. (78), J per
/// metre. @param dilating the locked dilation of its history; @param stiffness of its spring, N/m per metre.
inline double shear_energy(const LockedDilation& dilating, const ShearedContact& at, double stiffness) {
    const double force = at.spring_force(dilating);
    if (dilating.slope == 0) return force * force / (2 * stiffness);
    return dilating.stored_energy(force, stiffness, at.dilation, at.joint_share);
}
/// As above, of a contact at the start or the end of a step.
inline double shear_energy(const Model& model, const Contact& contact, double stiffness) {
    return shear_energy(locked_dilation(model, contact.joint_material, contact.history), sheared(contact),
                        stiffness);
}

/// The shear springs of the contacts of a joint segment. They are one spring of the joint, Eq. (81), with
/// that of contacts which are open: it stores the energy, and how the contacts share its force does not
/// count.
struct SharedSpring {
    double force = 0;      ///< N per metre
    double stiffness = 0;  ///< N/m per metre
    double stored = 0;     ///< J per metre, by the contacts one by one
    /// Adds the spring of a contact. @param spring_force N per metre; @param spring_stiffness N/m per metre.
    void add(double spring_force, double spring_stiffness) {
        force += spring_force;
        stiffness += spring_stiffness;
        stored += spring_force * spring_force / (2 * spring_stiffness);
    }
    /// Adds the spring of a contact that is open. @param spring_stiffness N/m per metre.
    void add_open(double spring_stiffness) { stiffness += spring_stiffness; }
    /// What the springs store one by one beyond that of the joint, J per metre, not negative.
    double uneven() const { return stiffness > 0 ? stored - force * force / (2 * stiffness) : 0; }
};

/// The energy at a step's start, before the slip that ends the match of the walls: from the first slip on,
/// the joint stores nothing in its dilation. @param after the locked dilation at the step's end.
inline double shear_energy_before_slip(const Model& model, const Contact& contact,
                                       const LockedDilation& after, double stiffness) {
    const LockedDilation before = locked_dilation(model, contact.joint_material, contact.history);
    const bool first_slip = before.reference_force > 0 && after.reference_force == 0;
    return shear_energy(first_slip ? LockedDilation{before.slope, 0} : before, sheared(contact), stiffness);
}

}  // namespace rockslope::dda
