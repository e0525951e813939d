#pragma once

#include "dda/contact/contact.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// A contact's normal spring, Eq. (43) or Eq. (44), with its stiffness in N/m per metre.
inline NormalClosure normal_spring(const Model& model, const Contact& contact) {
    return model.joint_material_at(contact.joint_material)
        .normal_spring(model.normal_penalty, contact.length);
}

/// Stiffness of its shear spring, N/m per metre: what the joint material gives, then what its law has found,
/// Eq. (58), then the analysis' penalty.
inline double shear_stiffness(const Model& model, const Contact& contact) {
    const JointMaterial& material = model.joint_material_at(contact.joint_material);
    const bool given = material.shear_stiffness > 0 || material.shear_penalty > 0;
    const double law_stiffness =
        given ? 0 : shear_stiffness(material.law, contact.history, 0, contact.length);
    return material.shear_spring(model.shear_penalty, contact.length, law_stiffness);
}

}  // namespace rockslope::dda
