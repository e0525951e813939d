#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "dda/contact/contact.hpp"
#include "dda/contact/contact_stiffness.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Motion of a contact in a step: the argument of its law. Where strengths are reduced, shear force and
/// stiffness are multiplied by the reduction factor, so that their ratio to the full strength is the same.
/// The spring of an augmented contact counts as unknown, because augmentation removes its deformation.
/// @param contact at the step's start; @param stiffness of its shear spring, N/m per metre; @param
/// normal_force at the end, N per metre; @param displacement and slip in m. The shear force follows the
/// normal force before the displacement.
inline ContactMotion contact_motion(const Model& model, const Contact& contact, double stiffness,
                                    double normal_force, double displacement, double slip) {
    ContactMotion motion;
    motion.slip = slip;
    motion.displacement = displacement;
    motion.normal_force = normal_force;
    motion.length = contact.length;
    const double slope = locked_dilation(model, contact.joint_material, contact.history).slope;
    const double by_dilation = (std::max(normal_force, 0.0) - contact.normal_force) * slope;
    motion.shear_force = (contact.shear_force + by_dilation) * model.strength_reduction;
    motion.spring_of_law = !model.joint_material_at(contact.joint_material).has_shear_spring();
    motion.stiffness = model.is_augmented(contact.joint_material) ? 0 : stiffness * model.strength_reduction;
    return motion;
}

/// The dilation that a step has left to the next one, m: that of the contact's history less that of the
/// contact.
inline double left_dilation(const Model& model, const Contact& contact) {
    const JointLaw& law = model.joint_material_at(contact.joint_material).law;
    return dilates(law) ? dilation(law, *contact.history) - contact.dilation : 0;
}

/// Motion of a joint segment in a step, and its history at the step's start.
struct SegmentMotion {
    ContactMotion motion;
    const SharedHistory* history = nullptr;
};

/// Part of one contact in the motion of its joint segment.
struct MemberWeight {
    bool counts = true;          ///< whether the segment's motion contains that of the contact
    double previous_weight = 0;  ///< weight of the counting contacts before it in `weighted_mean`
};

/// Whether any contact of a joint segment was closed at the step's start.
inline bool any_closed(std::span<const ContactIndex> members, ContactSpan<const Contact> contacts) {
    return std::any_of(members.begin(), members.end(),
                       [&](ContactIndex k) { return contacts[k].state != ContactState::open; });
}

/// The contact whose history and dilation a joint segment continues. Contacts that have just become one
/// segment continue those of the one with the largest force, of the contacts that count in `segment_motion`.
/// @param contacts at the step's start.
inline ContactIndex continued_contact(std::span<const ContactIndex> members,
                                      ContactSpan<const Contact> contacts) {
    const bool any_was_closed = any_closed(members, contacts);
    ContactIndex continued = members.front();
    double largest_normal_force = -1;
    for (const ContactIndex k : members) {
        const Contact& contact = contacts[k];
        if (any_was_closed && contact.state == ContactState::open) continue;
        const double normal_force = std::max(contact.normal_force, 0.0);
        if (!(normal_force > largest_normal_force)) continue;
        continued = k;
        largest_normal_force = normal_force;
    }
    return continued;
}

/// The history that a joint segment continues. @param contacts at the step's start.
inline const SharedHistory& continued_history(std::span<const ContactIndex> members,
                                              ContactSpan<const Contact> contacts) {
    return contacts[continued_contact(members, contacts)].history;
}

/// Motion of the joint segment with the contacts `members`, with its normal force, 0 if it is open. Only
/// contacts that were closed at the step's start count, or all if none was. Length and stiffness would
/// otherwise jump where a contact opens or closes during the step, and the step might have no solution.
/// @param contacts at the step's start; @param motion_of gives the motion of one contact; @param on_member is
/// called with each contact's index and MemberWeight.
template <class MotionOf, class OnMember>
SegmentMotion segment_motion(std::span<const ContactIndex> members, ContactSpan<const Contact> contacts,
                             const MotionOf& motion_of, const OnMember& on_member) {
    const auto at = [&](ContactIndex k) -> const Contact& { return contacts[k]; };
    const bool any_was_closed = any_closed(members, contacts);
    std::optional<SegmentMotion> combined;
    double total_normal_force = 0;
    for (const ContactIndex k : members) {
        const ContactMotion motion = motion_of(k);
        total_normal_force += std::max(motion.normal_force, 0.0);
        MemberWeight weight{!any_was_closed || at(k).state != ContactState::open, 0};
        if (weight.counts && combined) weight.previous_weight = weight_of_first(combined->motion, motion);
        on_member(k, weight);
        if (!weight.counts) continue;
        if (!combined)
            combined = {motion, nullptr};
        else
            combined->motion = combine(combined->motion, motion, weight.previous_weight);
    }
    combined->history = &continued_history(members, contacts);
    combined->motion.normal_force = total_normal_force;
    return *combined;
}
/// As above, of the segment as a whole.
template <class MotionOf>
SegmentMotion segment_motion(std::span<const ContactIndex> members, ContactSpan<const Contact> contacts,
                             const MotionOf& motion_of) {
    return segment_motion(members, contacts, motion_of, [](auto, const MemberWeight&) {});
}

}  // namespace rockslope::dda
