#include "dda/trial/segment_strength.hpp"

#include <cmath>
#include <optional>

namespace rockslope::dda {

namespace {

/// Length of the secant of the hardening, over the displacement at which the springs bear the strength.
constexpr double secant_length = 0.01;

}  // namespace

SegmentStrength::SegmentStrength(const StepProblem& problem)
    : p_(problem), strength_factor_(1 / problem.model.strength_reduction) {
    segment_of_.assign(p_.contacts.size(), -1);
    segments_.reserve(p_.segments.count());
    members_.reserve(p_.segments.first_member(p_.segments.count()));
    for (std::size_t index = 0; index < p_.segments.count(); ++index) {
        const std::span<const ContactIndex> members = p_.segments.contacts_of(index);
        const auto& first = p_.contacts[members[0]];
        Segment& segment = segments_.emplace_back();
        segment.first = static_cast<std::uint32_t>(members_.size());
        segment.count = static_cast<std::uint32_t>(members.size());
        segment.law = &p_.model.joint_material_at(first.joint_material).law;
        // The normal force is arbitrary here: only the state at the step's start decides which contacts
        // count.
        const auto motion_of = [&](ContactIndex k) {
            ContactMotion motion =
                contact_motion(p_.model, p_.contacts[k], p_.springs[k].shear_stiffness, 1, 0, 0);
            motion.shear_force = p_.contacts[k].shear_force * p_.model.strength_reduction;
            return motion;
        };
        const auto add_member = [&](ContactIndex k, const MemberWeight& weight) {
            if (weight.counts) segment.normal_force += p_.contacts[k].normal_force;
            members_.push_back({k, weight});
        };
        const SegmentMotion combined = segment_motion(members, p_.contacts, motion_of, add_member);
        segment.history = &**combined.history;
        segment.length = combined.motion.length;
        segment.shear_force = combined.motion.shear_force;
        segment.locked_slope = locked_dilation(p_.model, first.joint_material, *segment.history).slope *
                               p_.model.strength_reduction;
        segment.shear_stiffness = combined.motion.stiffness;
        for (const ContactIndex k : members) {
            segment_of_[k] = static_cast<int>(index);
            segment.stiffness += p_.springs[k].shear_stiffness;
        }
    }
}

Strength SegmentStrength::over_normal_force(std::size_t index, const SegmentLoading& loading) const {
    const Segment& segment = segments_[index];
    const Strength strengths =
        strength(*segment.law, *segment.history, loading.normal, segment.length,
                 {loading.displacement,
                  segment.shear_force + (loading.normal - segment.normal_force) * segment.locked_slope,
                  segment.shear_stiffness});
    return strength_factor_ / loading.normal * strengths;
}

/// The slope of Eq. (102).
Hardening SegmentStrength::hardening(std::size_t index, const SegmentLoading& loading,
                                     const Strength& strength) const {
    const int direction = sign_of(loading.displacement);
    const auto ahead = [&](const Strength& s) { return direction > 0 ? s.forward : s.backward; };
    const double further = secant_length * ahead(strength) * loading.normal / stiffness(index);
    if (direction == 0 || !(further > 0) || !std::isfinite(further)) return {};
    const Strength there =
        over_normal_force(index, {loading.normal, loading.displacement + direction * further});
    const double of_ahead = std::max((ahead(there) - ahead(strength)) / further, 0.0);
    return direction > 0 ? Hardening{of_ahead, 0} : Hardening{0, of_ahead};
}

}  // namespace rockslope::dda
