#include "dda/joint/shear_step.hpp"

#include <algorithm>

namespace rockslope::dda {

ShearedJoint shear(const JointLaw& law, const ShearedJoint& joint, double displacement,
                   const JointLoad& load) {
    const Strength bounds = strength(law, joint.history, load.normal_force, load.length,
                                     {displacement, joint.shear_force, load.stiffness});
    const double elastic = joint.shear_force + load.stiffness * displacement;
    ShearedJoint after;
    after.shear_force = load.normal_force > 0 ? std::clamp(elastic, -bounds.backward, bounds.forward) : 0.0;
    const double slip = (elastic - after.shear_force) / load.stiffness;
    after.slip = joint.slip + slip;
    after.sliding = slip != 0;
    after.history = advance(law, joint.history,
                            {slip, displacement, load.normal_force, load.length, false, joint.shear_force,
                             load.stiffness, load.duration});
    return after;
}

}  // namespace rockslope::dda
