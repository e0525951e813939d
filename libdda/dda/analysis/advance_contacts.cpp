#include "dda/analysis/advance_contacts.hpp"

#include "dda/analysis/joint_motion.hpp"
#include "dda/contact/detect.hpp"

namespace dda {

namespace {

/// Histories first: they are advanced from the forces at the step's start.
void advance_histories(const Model& model, const JointFaces& faces, std::span<const JudgedContact> judged,
                       std::span<const ContactSprings> springs, double duration, const Crew& crew,
                       std::span<Contact> contacts) {
    const auto motion = [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        ContactMotion made = contact_motion(model, contacts[i], springs[i].shear_stiffness,
                                            judged[i].normal_force, judged[i].displacement, judged[i].slip);
        made.opened = judged[i].torn;
        made.duration = duration;
        return made;
    };
    crew.for_ranges(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const JointLaw& law = model.joint_material_at(contacts[k].joint_material).law;
            if (belongs_to_faces(law)) continue;
            const JointHistory moved = advance(law, contacts[k].history, motion(static_cast<int>(k)));
            if (moved != *contacts[k].history) contacts[k].history = moved;
        }
    });
    crew.for_ranges(faces.count(), [&](std::size_t begin, std::size_t end) {
        SharedHistory::Row row(faces.members_before(end) - faces.members_before(begin));
        for (std::size_t f = begin; f < end; ++f) {
            const std::span<const int> members = faces.contacts_of(f);
            const int material = contacts[static_cast<std::size_t>(members[0])].joint_material;
            const JointLaw& law = model.joint_material_at(material).law;
            const std::optional<FacesMotion> whole = faces_motion(members, contacts, motion);
            if (!whole) {  // these keep theirs, anew: a few would keep all that was made with them
                for (const int k : members) {
                    SharedHistory& history = contacts[static_cast<std::size_t>(k)].history;
                    history = row.add(history);
                }
                continue;
            }
            const SharedHistory moved = row.add(advance(law, *whole->history, whole->motion));
            for (const int k : members)
                contacts[static_cast<std::size_t>(k)].take_history(moved, dilation(law, moved));
        }
    });
}

/// What a contact is at the step's end. @param law its joint's; @param next corner of its edge.
void advance_contact(const JointLaw& law, std::span<const Vec2> vertices, int next,
                     const JudgedContact& result, Contact& contact) {
    const auto at = [&](int corner) { return vertices[static_cast<std::size_t>(corner)]; };
    const CornerEdgeGeometry geometry = corner_edge_geometry(at(contact.corner), at(contact.edge), at(next));
    contact.point = at(contact.corner);
    contact.normal = geometry.normal;
    contact.tangent = geometry.tangent;
    contact.gap = geometry.gap - contact.dilation;
    contact.state = result.state;
    contact.rest_gap = result.rest_gap;
    contact.normal_force = result.normal_force;
    contact.shear_force = result.shear_force;
    contact.slip += result.slip;
    contact.bonded =
        contact.bonded && !result.torn && strength(law, contact.history, 0, contact.length).tensile > 0;
}

}  // namespace

void advance_contacts(const Model& model, const JointFaces& faces, std::span<const Vec2> vertices,
                      std::span<const JudgedContact> judged, std::span<const ContactSprings> springs,
                      double duration, const Crew& crew, std::span<Contact> contacts) {
    advance_histories(model, faces, judged, springs, duration, crew, contacts);
    crew.for_ranges(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Contact& contact = contacts[k];
            advance_contact(model.joint_material_at(contact.joint_material).law, vertices,
                            model.topology.next[static_cast<std::size_t>(contact.edge)], judged[k], contact);
        }
    });
}

}  // namespace dda
