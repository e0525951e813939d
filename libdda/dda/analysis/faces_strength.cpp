#include "dda/analysis/faces_strength.hpp"

#include <optional>

#include "dda/analysis/joint_motion.hpp"

namespace dda {

FacesStrength::FacesStrength(const StepProblem& problem)
    : p_(problem), reduced_(1 / problem.model.strength_reduction) {
    pair_of_.assign(p_.contacts.size(), -1);
    pairs_.reserve(p_.faces.count());
    members_.reserve(p_.faces.members_before(p_.faces.count()));
    for (std::size_t f = 0; f < p_.faces.count(); ++f) {
        const std::span<const int> members = p_.faces.contacts_of(f);
        const auto& first = p_.contacts[static_cast<std::size_t>(members[0])];
        Pair& pair = pairs_.emplace_back();
        pair.first = static_cast<std::uint32_t>(members_.size());
        pair.count = static_cast<std::uint32_t>(members.size());
        pair.law = &p_.model.joint_material_at(first.joint_material).law;
        // Any force will do: which contacts tell the faces' motion and history is a matter of the step's
        // start.
        const std::optional<FacesMotion> whole = faces_motion(members, p_.contacts, [&](int k) {
            const auto c = static_cast<std::size_t>(k);
            return contact_motion(p_.model, p_.contacts[c], p_.springs[c].shear_stiffness, 1, 0, 0);
        });
        pair.history = &**whole->history;
        pair.length = whole->motion.length;
        pair.shear_force = whole->motion.shear_force;
        pair.shear_stiffness = whole->motion.stiffness;
        for (const int k : members) {
            const auto c = static_cast<std::size_t>(k);
            pair_of_[c] = static_cast<int>(f);
            pair.stiffness += p_.springs[c].shear_stiffness;
        }
        add_members(members);
    }
}

/// As `together` weights displacements, one contact after the other.
void FacesStrength::add_members(std::span<const int> contacts) {
    const bool any_was = any_closed(contacts, p_.contacts);
    std::optional<ContactMotion> so_far;
    for (const int k : contacts) {
        const auto c = static_cast<std::size_t>(k);
        const Contact& contact = p_.contacts[c];
        Member member{k, !any_was || contact.state != ContactState::open, 0, 1};
        if (member.moves) {
            const ContactMotion one =
                contact_motion(p_.model, contact, p_.springs[c].shear_stiffness, 1, 0, 0);
            if (so_far) {
                so_far->displacement = 1;
                so_far = together(*so_far, one);
                member.before = so_far->displacement;
                member.share = 1 - member.before;
            } else {
                so_far = one;
            }
        }
        members_.push_back(member);
    }
}

Strength FacesStrength::over_normal_force(std::size_t index, const FacesPressed& pressed) const {
    const Pair& pair = pairs_[index];
    Strength strengths = strength(*pair.law, *pair.history, pressed.normal, pair.length,
                                  {pressed.displacement, pair.shear_force, pair.shear_stiffness});
    const double share = reduced_ / pressed.normal;
    for (double* one : {&strengths.forward, &strengths.backward, &strengths.tensile}) *one *= share;
    return strengths;
}

}  // namespace dda
