#pragma once

#include "dda/joint/joint_law.hpp"

namespace rockslope::dda {

/// A joint that is sheared by itself, without blocks: a share of `length` m with a shear spring.
struct ShearedJoint {
    JointHistory history;
    double shear_force = 0;  ///< N per metre, resists motion in the positive direction
    double slip = 0;         ///< accumulated plastic slip, m
    bool sliding = false;    ///< in the last displacement
};

/// What loads the joint during a displacement.
struct JointLoad {
    double normal_force = 0;  ///< N per metre, compression positive
    double length = 0;        ///< m
    double stiffness = 0;     ///< of the shear spring, N/m per metre, positive
    double duration = 0;      ///< of the displacement, s; 0: static
};

/// The joint after a displacement (m, positive forward): the elastic predictor S + k s, clipped to the law's
/// strength at the displacement's end, Eq. (32), and the history advanced. What a contact does in a step.
ShearedJoint shear(const JointLaw& law, const ShearedJoint& joint, double displacement,
                   const JointLoad& load);

}  // namespace rockslope::dda
