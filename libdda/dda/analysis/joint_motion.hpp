#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// What a contact did in a step, as its law takes it. Where strengths are reduced the law is told the shear
/// load that would be as near to the full strength. An augmented contact does not give way: its law is told
/// of no spring. @param contact at the step's start; @param stiffness of its shear spring; @param
/// normal_force at the end.
inline ContactMotion contact_motion(const Model& model, const Contact& contact, double stiffness,
                                    double normal_force, double displacement, double slip) {
    ContactMotion motion;
    motion.slip = slip;
    motion.displacement = displacement;
    motion.normal_force = normal_force;
    motion.length = contact.length;
    motion.shear_force = contact.shear_force * model.strength_reduction;
    motion.stiffness = model.is_augmented(contact.joint_material) ? 0 : stiffness * model.strength_reduction;
    return motion;
}

/// What a pair of faces does, and what it has been through so far.
struct SegmentMotion {
    ContactMotion motion;
    const SharedHistory* history = nullptr;
};

/// Whether a contact of a pair of faces was closed at the step's start.
inline bool any_closed(std::span<const int> members, std::span<const Contact> contacts) {
    return std::any_of(members.begin(), members.end(), [&](int k) {
        return contacts[static_cast<std::size_t>(k)].state != ContactState::open;
    });
}

/// The motion of a pair of faces, whose contacts in `members` move together; nothing if none is pressed. They
/// are those that were closed at the step's start, or all if none was: length and stiffness must not jump
/// where a contact opens or closes on the way, or there may be no state that the joint could come to.
/// @param contacts at the step's start; @param motion_of gives the motion of one.
template <class MotionOf>
std::optional<SegmentMotion> segment_motion(std::span<const int> members, std::span<const Contact> contacts,
                                            const MotionOf& motion_of) {
    const auto at = [&](int k) -> const Contact& { return contacts[static_cast<std::size_t>(k)]; };
    const bool any_was_closed = any_closed(members, contacts);
    std::optional<SegmentMotion> combined;
    double largest_normal_force = 0, total_normal_force = 0;
    for (const int k : members) {
        const ContactMotion motion = motion_of(k);
        total_normal_force += std::max(motion.normal_force, 0.0);
        if (any_was_closed && at(k).state == ContactState::open) continue;
        if (!combined)
            combined = {motion, &at(k).history};
        else
            combined->motion = combine(combined->motion, motion);
        // Faces that have just come to lie on each other take up where the one that bore more has been.
        if (at(k).normal_force > largest_normal_force) {
            largest_normal_force = at(k).normal_force;
            combined->history = &at(k).history;
        }
    }
    if (!(total_normal_force > 0)) return std::nullopt;
    combined->motion.normal_force = total_normal_force;
    return combined;
}

}  // namespace rockslope::dda
