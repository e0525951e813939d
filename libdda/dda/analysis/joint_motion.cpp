#include "dda/analysis/joint_motion.hpp"

namespace dda {

ShearLoad shear_load(const Model& model, const Contact& contact, double stiffness) {
    const bool gives_way = !model.augments(contact.joint_material);
    return {contact.shear_force * model.strength_reduction,
            gives_way ? stiffness * model.strength_reduction : 0};
}

ContactMotion contact_motion(const Model& model, const Contact& contact, double stiffness,
                             double normal_force, double displacement, double slip) {
    const ShearLoad start = shear_load(model, contact, stiffness);
    ContactMotion motion;
    motion.slip = slip;
    motion.displacement = displacement;
    motion.normal_force = normal_force;
    motion.length = contact.length;
    motion.shear_force = start.force;
    motion.stiffness = start.stiffness;
    return motion;
}

}  // namespace dda
