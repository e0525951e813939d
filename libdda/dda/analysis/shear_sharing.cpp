#include "dda/analysis/shear_sharing.hpp"

#include <algorithm>
#include <span>

#include "dda/contact/contact_stiffness.hpp"
#include "dda/trial/joint_motion.hpp"

namespace rockslope::dda {

namespace {

/// Least share of a contact in its joint segment: a contact without a normal force has a spring too, for it
/// may close.
constexpr double least_share = 1e-3;

/// Sums over the contacts of a joint segment; forces in N per metre.
struct Totals {
    double shear_force = 0;
    double normal_force = 0;
    double length = 0;     ///< m
    double stiffness = 0;  ///< N/m per metre, without the law's spring
};

Totals totals_of(const Model& model, const JointMaterial& material, std::span<const ContactIndex> members,
                 ContactSpan<Contact> contacts) {
    Totals total;
    for (const ContactIndex k : members) {
        total.shear_force += contacts[k].shear_force;
        total.normal_force += std::max(contacts[k].normal_force, 0.0);
        total.length += contacts[k].length;
        total.stiffness += material.shear_spring(model.shear_penalty, contacts[k].length);
    }
    return total;
}

}  // namespace

void share_shear_force(const Model& model, const JointSegments& segments, ContactSpan<Contact> contacts) {
    for (std::size_t segment = 0; segment < segments.count(); ++segment) {
        const auto members = segments.contacts_of(segment);
        const JointMaterialIndex joint_material = contacts[members[0]].joint_material;
        const JointMaterial& material = model.joint_material_at(joint_material);
        const Contact& continued = contacts[continued_contact(members, contacts)];
        const SharedHistory history = continued.history;
        const double dilation = continued.dilation;
        for (const ContactIndex k : members) contacts[k].inherit_history(history, dilation);
        const Totals total = totals_of(model, material, members, contacts);
        const bool by_force = total.normal_force > 0 && !model.is_augmented(joint_material);
        for (const ContactIndex k : members) {
            Contact& contact = contacts[k];
            const double by_length =
                total.length > 0 ? contact.length / total.length : 1 / static_cast<double>(members.size());
            const double share =
                by_force ? std::max(contact.normal_force, 0.0) / total.normal_force : by_length;
            if (by_force) contact.shear_force = total.shear_force * share;
            contact.joint_share = std::max(share, least_share);
            contact.spring_share = contact.joint_share;
            // Springs that the model gives are those of the contacts.
            if (material.has_shear_spring() || joint_stiffness(model, contact) == 0)
                contact.spring_share *=
                    total.stiffness / material.shear_spring(model.shear_penalty, contact.length);
        }
    }
}

}  // namespace rockslope::dda
