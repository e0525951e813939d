#include "dda/analysis/advance_contacts.hpp"

#include "dda/contact/detect.hpp"

namespace dda {

void advance_contacts(const Model& model, std::span<const Vec2> vertices,
                      std::span<const JudgedContact> judged, std::span<Contact> contacts) {
    const auto at = [&](int corner) { return vertices[static_cast<std::size_t>(corner)]; };
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        Contact& contact = contacts[k];
        const JudgedContact& result = judged[k];
        const JointLaw& law = model.joint_material_at(contact.joint_material).law;
        const CornerEdgeGeometry geometry =
            corner_edge_geometry(at(contact.corner), at(contact.edge),
                                 at(model.topology.next[static_cast<std::size_t>(contact.edge)]));
        contact.point = at(contact.corner);
        contact.normal = geometry.normal;
        contact.tangent = geometry.tangent;
        contact.gap = geometry.gap;
        contact.state = result.state;
        contact.rest_gap = result.rest_gap;
        contact.normal_force = result.normal_force;
        contact.shear_force = result.shear_force;
        contact.slip += result.slip;
        contact.history = dda::advance(
            law, contact.history,
            {result.slip, result.displacement, result.normal_force, contact.length, result.torn});
        contact.bonded =
            contact.bonded && !result.torn && strength(law, contact.history, 0, contact.length).tensile > 0;
    }
}

}  // namespace dda
