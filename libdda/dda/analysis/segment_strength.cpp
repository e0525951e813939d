#include "dda/analysis/segment_strength.hpp"

#include <optional>

#include "dda/analysis/joint_motion.hpp"

namespace rockslope::dda {

SegmentStrength::SegmentStrength(const StepProblem& problem)
    : p_(problem), strength_factor_(1 / problem.model.strength_reduction) {
    segment_of_.assign(p_.contacts.size(), -1);
    segments_.reserve(p_.segments.count());
    members_.reserve(p_.segments.first_member(p_.segments.count()));
    for (std::size_t f = 0; f < p_.segments.count(); ++f) {
        const std::span<const int> members = p_.segments.contacts_of(f);
        const auto& first = p_.contacts[static_cast<std::size_t>(members[0])];
        Segment& segment = segments_.emplace_back();
        segment.first = static_cast<std::uint32_t>(members_.size());
        segment.count = static_cast<std::uint32_t>(members.size());
        segment.law = &p_.model.joint_material_at(first.joint_material).law;
        // Any force will do: which contacts tell the faces' motion and history is a matter of the step's
        // start.
        const std::optional<SegmentMotion> combined = segment_motion(members, p_.contacts, [&](int k) {
            const auto c = static_cast<std::size_t>(k);
            return contact_motion(p_.model, p_.contacts[c], p_.springs[c].shear_stiffness, 1, 0, 0);
        });
        segment.history = &**combined->history;
        segment.length = combined->motion.length;
        segment.shear_force = combined->motion.shear_force;
        segment.shear_stiffness = combined->motion.stiffness;
        for (const int k : members) {
            const auto c = static_cast<std::size_t>(k);
            segment_of_[c] = static_cast<int>(f);
            segment.stiffness += p_.springs[c].shear_stiffness;
        }
        add_members(members);
    }
}

/// As `combine` weights displacements, one contact after the other.
void SegmentStrength::add_members(std::span<const int> contacts) {
    const bool any_closed_before = any_closed(contacts, p_.contacts);
    std::optional<ContactMotion> so_far;
    for (const int k : contacts) {
        const auto c = static_cast<std::size_t>(k);
        const Contact& contact = p_.contacts[c];
        Member member{k, !any_closed_before || contact.state != ContactState::open, 0, 1};
        if (member.counts) {
            const ContactMotion one =
                contact_motion(p_.model, contact, p_.springs[c].shear_stiffness, 1, 0, 0);
            if (so_far) {
                so_far->displacement = 1;
                so_far = combine(*so_far, one);
                member.previous_weight = so_far->displacement;
                member.weight = 1 - member.previous_weight;
            } else {
                so_far = one;
            }
        }
        members_.push_back(member);
    }
}

Strength SegmentStrength::over_normal_force(std::size_t index, const SegmentLoading& loading) const {
    const Segment& segment = segments_[index];
    Strength strengths = strength(*segment.law, *segment.history, loading.normal, segment.length,
                                  {loading.displacement, segment.shear_force, segment.shear_stiffness});
    const double factor = strength_factor_ / loading.normal;
    for (double* one : {&strengths.forward, &strengths.backward, &strengths.tensile}) *one *= factor;
    return strengths;
}

}  // namespace rockslope::dda
