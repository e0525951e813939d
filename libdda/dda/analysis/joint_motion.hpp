#pragma once

#include <optional>
#include <span>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace dda {

/// What a contact did in a step, as its law takes it. Where strengths are reduced the law is told the shear
/// load that would be as near to the full strength. An augmented contact does not give way: its law is told
/// of no spring. @param contact at the step's start; @param stiffness of its shear spring; @param
/// normal_force at the end.
ContactMotion contact_motion(const Model& model, const Contact& contact, double stiffness,
                             double normal_force, double displacement, double slip);

/// What a pair of faces does, and what it has been through so far.
struct FacesMotion {
    ContactMotion motion;
    const JointHistory* history = nullptr;
};

/// The motion of a pair of faces, whose contacts in `members` move together; nothing if none is pressed.
/// @param contacts at the step's start; @param motion_of gives the motion of one.
template <class MotionOf>
std::optional<FacesMotion> faces_motion(std::span<const int> members, std::span<const Contact> contacts,
                                        const MotionOf& motion_of) {
    std::optional<FacesMotion> whole;
    double borne = 0;
    for (const int k : members) {
        const ContactMotion motion = motion_of(k);
        if (!(motion.normal_force > 0)) continue;
        const Contact& contact = contacts[static_cast<std::size_t>(k)];
        if (!whole)
            whole = {motion, &contact.history};
        else
            whole->motion = together(whole->motion, motion);
        // Faces that have just come to lie on each other take up where the one that bore more has been.
        if (contact.normal_force > borne) {
            borne = contact.normal_force;
            whole->history = &contact.history;
        }
    }
    return whole;
}

}  // namespace dda
