#include "dda/analysis/advance_contacts.hpp"

#include "dda/contact/detect.hpp"
#include "dda/trial/joint_motion.hpp"

namespace rockslope::dda {

namespace {

/// Advances the histories. `contacts` still have the forces of the step's start. A closed contact dilates by
/// what the step was solved with; what its history dilates by beyond that is left to the next step.
void advance_histories(const Model& model, const ContactStep& step, const ThreadPool& pool,
                       ContactSpan<Contact> contacts) {
    const JointSegments& segments = step.segments;
    const auto motion = [&](ContactIndex k) {
        const EvaluatedContact& evaluated = step.evaluated[k];
        ContactMotion made = contact_motion(model, contacts[k], step.springs[k].shear_stiffness,
                                            evaluated.normal_force, evaluated.displacement, evaluated.slip);
        made.opened = evaluated.bond_broken;
        made.closing = contacts[k].state == ContactState::open;
        made.time = step.time;
        made.bond_holds = step.bonds_hold;
        return made;
    };
    pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            const JointLaw& law = model.joint_material_at(contacts[k].joint_material).law;
            if (has_segment_history(law)) continue;
            const JointHistory moved = advance(law, contacts[k].history, motion(k));
            if (moved != *contacts[k].history) contacts[k].history = moved;
        }
    });
    pool.parallel_for(segments.count(), [&](std::size_t begin, std::size_t end) {
        SharedHistory::Batch batch(segments.first_member(end) - segments.first_member(begin));
        for (std::size_t segment = begin; segment < end; ++segment) {
            const auto members = segments.contacts_of(segment);
            const JointMaterialIndex material = contacts[members[0]].joint_material;
            const JointLaw& law = model.joint_material_at(material).law;
            const SegmentMotion combined = segment_motion(members, contacts, motion);
            const SharedHistory moved = batch.add(advance(law, *combined.history, combined.motion));
            const double dilated = dilation(law, moved);
            for (const ContactIndex k : members) {
                const EvaluatedContact& evaluated = step.evaluated[k];
                const bool is_open = evaluated.state == ContactState::open;
                contacts[k].inherit_history(
                    moved, is_open ? dilated : contacts[k].dilation + evaluated.dilation_increment);
            }
        }
    });
}

/// Advances a contact to the step's end. @param law of its joint; @param edge_end second corner of its edge.
void advance_contact(const JointLaw& law, CornerSpan<const Vec2> vertices, CornerIndex edge_end,
                     const EvaluatedContact& result, Contact& contact) {
    const CornerEdgeGeometry geometry =
        corner_edge_geometry(vertices[contact.corner], vertices[start_of(contact.edge)], vertices[edge_end]);
    contact.point = vertices[contact.corner];
    contact.normal = geometry.normal;
    contact.tangent = geometry.tangent;
    contact.gap = geometry.gap - contact.dilation;
    contact.state = result.state;
    contact.stress_free_gap = result.stress_free_gap;
    contact.normal_force = result.normal_force;
    contact.normal_spring_force = result.normal_spring_force;
    contact.shear_force = result.state == ContactState::open ? 0 : result.shear_force;
    contact.slip += result.slip;
    contact.bonded = contact.bonded && !result.bond_broken &&
                     strength(law, contact.history, 0, contact.length).tensile > 0;
}

}  // namespace

void advance_contacts(const Model& model, const ContactStep& step, const ThreadPool& pool,
                      ContactSpan<Contact> contacts) {
    advance_histories(model, step, pool, contacts);
    pool.parallel_for(contacts.size(), [&](std::size_t begin, std::size_t end) {
        for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
            Contact& contact = contacts[k];
            advance_contact(model.joint_material_at(contact.joint_material).law, step.vertices,
                            model.topology.end_of(contact.edge), step.evaluated[k], contact);
        }
    });
}

}  // namespace rockslope::dda
