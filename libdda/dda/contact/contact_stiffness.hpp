#pragma once

#include <limits>

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The normal spring of a contact, Eq. (43) or Eq. (44); stiffness in N/m per metre of thickness.
inline NormalClosure normal_spring(const Model& model, const Contact& contact) {
    return model.joint_material_at(contact.joint_material)
        .normal_spring(model.normal_penalty, contact.length);
}

/// Stiffness of the shear spring that the law gives a joint, whatever its contacts, Eq. (58), N/m per metre
/// of thickness; 0: none, or not loaded yet.
inline double joint_stiffness(const Model& model, const Contact& contact) {
    return shear_stiffness(model.joint_material_at(contact.joint_material).law, contact.history, 0,
                           std::numeric_limits<double>::infinity());
}

/// Shear stiffness of a contact, N/m per metre of thickness. The first of these that is set: the stiffness of
/// the joint material, Eq. (43); its shear penalty; the stiffness of its joint law, Eq. (58); the shear
/// penalty of the analysis. The contacts of a joint segment share it, Eq. (81).
inline double shear_stiffness(const Model& model, const Contact& contact) {
    const JointMaterial& material = model.joint_material_at(contact.joint_material);
    const double law_stiffness = material.has_shear_spring() ? 0 : joint_stiffness(model, contact);
    return contact.spring_share * material.shear_spring(model.shear_penalty, contact.length, law_stiffness);
}

/// How the shear force of a locked contact follows its normal force, Eq. (77). An augmented contact is rigid,
/// and its dilation does no work.
inline LockedDilation locked_dilation(const Model& model, JointMaterialIndex joint_material,
                                      const JointHistory& history) {
    const JointLaw& law = model.joint_material_at(joint_material).law;
    if (!dilates(law) || model.is_augmented(joint_material)) return {};
    return locked_dilation(law, history);
}

}  // namespace rockslope::dda
