#include "dda/analysis/joint_motion.hpp"

namespace dda {

ContactMotion contact_motion(const Model& model, const Contact& contact, double stiffness,
                             double normal_force, double displacement, double slip) {
    ContactMotion motion;
    motion.slip = slip;
    motion.displacement = displacement;
    motion.normal_force = normal_force;
    motion.length = contact.length;
    motion.shear_force = contact.shear_force * model.strength_reduction;
    motion.stiffness = model.augments(contact.joint_material) ? 0 : stiffness * model.strength_reduction;
    return motion;
}

}  // namespace dda
