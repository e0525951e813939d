#pragma once

#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

/// State of a joint with a shear spring that is sheared without blocks.
struct ShearedJoint {
    JointHistory history;
    double shear_force = 0;   ///< N per metre, resists motion in the positive direction
    double normal_force = 0;  ///< N per metre, at the last displacement
    double slip = 0;          ///< accumulated plastic slip, m
    bool sliding = false;     ///< during the last displacement
};

/// Load of the joint during a displacement, and its shear spring.
struct JointLoad {
    double normal_force = 0;  ///< N per metre, compression positive
    double length = 0;        ///< m
    double stiffness = 0;     ///< of the shear spring, N/m per metre, positive
    StepTime time = {};       ///< of the displacement
};

/// The joint after a displacement (m, positive forward): the elastic predictor S + k s, limited to the law's
/// strength at the end of the displacement, Eq. (32), and the advanced history. A contact does the same in a
/// step.
ShearedJoint shear(const JointLaw& law, const ShearedJoint& joint, double displacement,
                   const JointLoad& load);

}  // namespace rockslope::dda
