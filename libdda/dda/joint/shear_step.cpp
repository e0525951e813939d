#include "dda/joint/shear_step.hpp"

#include <algorithm>

namespace rockslope::dda {

ShearedJoint shear(const JointLaw& law, const ShearedJoint& joint, double displacement,
                   const JointLoad& load) {
    const double normal_force = std::max(load.normal_force, 0.0);
    const LockedDilation before = locked_dilation(law, joint.history);
    // The normal force changes first, at rest, and the shear force of the locked joint follows it, Eq. (77).
    const double start_force =
        joint.shear_force + before.shear_force(normal_force, 1) - before.shear_force(joint.normal_force, 1);
    const Strength bounds =
        strength(law, joint.history, normal_force, load.length, {displacement, start_force, load.stiffness});
    ContactMotion motion{0,     displacement, normal_force,   load.length,
                         false, start_force,  load.stiffness, load.time};
    ShearedJoint after;
    after.history = advance(law, joint.history, motion);
    const LockedDilation dilating = after_displacement(before, locked_dilation(law, after.history));
    const double elastic = start_force + load.stiffness * displacement +
                           dilating.shear_force(normal_force, 1) - before.shear_force(normal_force, 1);
    after.normal_force = normal_force;
    after.shear_force = normal_force > 0 ? std::clamp(elastic, -bounds.backward, bounds.forward) : 0.0;
    motion.slip = (elastic - after.shear_force) / load.stiffness;
    after.slip = joint.slip + motion.slip;
    after.sliding = motion.slip != 0;
    after.history = advance(law, joint.history, motion);
    return after;
}

}  // namespace rockslope::dda
