#include "dda/analysis/advance_contacts.hpp"

#include "dda/analysis/joint_motion.hpp"
#include "dda/contact/detect.hpp"

namespace rockslope::dda {

namespace {

/// Histories first: they are advanced from the forces at the step's start.
void advance_histories(const Model& model, const JointSegments& segments,
                       std::span<const EvaluatedContact> evaluated, std::span<const ContactSprings> springs,
                       double duration, const ThreadPool& pool, std::span<Contact> contacts) {
    const auto motion = [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        ContactMotion made =
            contact_motion(model, contacts[i], springs[i].shear_stiffness, evaluated[i].normal_force,
                           evaluated[i].displacement, evaluated[i].slip);
        made.opened = evaluated[i].bond_broken;
        made.duration = duration;
        return made;
    };
    pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const JointLaw& law = model.joint_material_at(contacts[k].joint_material).law;
            if (has_segment_history(law)) continue;
            const JointHistory moved = advance(law, contacts[k].history, motion(static_cast<int>(k)));
            if (moved != *contacts[k].history) contacts[k].history = moved;
        }
    });
    pool.parallel_for(segments.count(), [&](std::size_t begin, std::size_t end) {
        SharedHistory::Batch batch(segments.first_member(end) - segments.first_member(begin));
        for (std::size_t f = begin; f < end; ++f) {
            const std::span<const int> members = segments.contacts_of(f);
            const int material = contacts[static_cast<std::size_t>(members[0])].joint_material;
            const JointLaw& law = model.joint_material_at(material).law;
            const std::optional<SegmentMotion> combined = segment_motion(members, contacts, motion);
            if (!combined) {  // these keep theirs, anew: a few would keep all that was made with them
                for (const int k : members) {
                    SharedHistory& history = contacts[static_cast<std::size_t>(k)].history;
                    history = batch.add(history);
                }
                continue;
            }
            const SharedHistory moved = batch.add(advance(law, *combined->history, combined->motion));
            for (const int k : members)
                contacts[static_cast<std::size_t>(k)].inherit_history(moved, dilation(law, moved));
        }
    });
}

/// What a contact is at the step's end. @param law its joint's; @param next corner of its edge.
void advance_contact(const JointLaw& law, std::span<const Vec2> vertices, int next,
                     const EvaluatedContact& result, Contact& contact) {
    const auto at = [&](int corner) { return vertices[static_cast<std::size_t>(corner)]; };
    const CornerEdgeGeometry geometry = corner_edge_geometry(at(contact.corner), at(contact.edge), at(next));
    contact.point = at(contact.corner);
    contact.normal = geometry.normal;
    contact.tangent = geometry.tangent;
    contact.gap = geometry.gap - contact.dilation;
    contact.state = result.state;
    contact.stress_free_gap = result.stress_free_gap;
    contact.normal_force = result.normal_force;
    contact.shear_force = result.shear_force;
    contact.slip += result.slip;
    contact.bonded = contact.bonded && !result.bond_broken &&
                     strength(law, contact.history, 0, contact.length).tensile > 0;
}

}  // namespace

void advance_contacts(const Model& model, const JointSegments& segments, std::span<const Vec2> vertices,
                      std::span<const EvaluatedContact> evaluated, std::span<const ContactSprings> springs,
                      double duration, const ThreadPool& pool, std::span<Contact> contacts) {
    advance_histories(model, segments, evaluated, springs, duration, pool, contacts);
    pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Contact& contact = contacts[k];
            advance_contact(model.joint_material_at(contact.joint_material).law, vertices,
                            model.topology.next[static_cast<std::size_t>(contact.edge)], evaluated[k],
                            contact);
        }
    });
}

}  // namespace rockslope::dda
