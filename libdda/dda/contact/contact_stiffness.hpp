#pragma once

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The normal spring of a contact, Eq. (43) or Eq. (44); stiffness in N/m per metre of thickness.
inline NormalClosure normal_spring(const Model& model, const Contact& contact) {
    return model.joint_material_at(contact.joint_material)
        .normal_spring(model.normal_penalty, contact.length);
}

/// Shear stiffness of a contact, N/m per metre of thickness. The first of these that is set: the stiffness of
/// the joint material, Eq. (43); its shear penalty; the stiffness of its joint law, Eq. (58); the shear
/// penalty of the analysis.
inline double shear_stiffness(const Model& model, const Contact& contact) {
    const JointMaterial& material = model.joint_material_at(contact.joint_material);
    const bool given = material.shear_stiffness > 0 || material.shear_penalty > 0;
    const double law_stiffness =
        given ? 0 : shear_stiffness(material.law, contact.history, 0, contact.length);
    return material.shear_spring(model.shear_penalty, contact.length, law_stiffness);
}

}  // namespace rockslope::dda
