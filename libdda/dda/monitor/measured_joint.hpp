#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// What a laboratory would measure of a joint, SI. Displacements count as those of measured points do. The
/// forces are those of the contacts between the two faces' blocks along this joint.
struct JointReading {
    double displacement = 0;   ///< m, of the faces past each other, the joint's give included; positive where
                               ///< the rock above goes to the right
    double dilation = 0;       ///< m, of the faces apart
    double shear_stress = 0;   ///< Pa, over the length in contact; resists positive displacement
    double normal_stress = 0;  ///< Pa, compression positive
    double strength = 0;       ///< Pa, the smaller of those against motion in either direction
    double slip = 0;           ///< m, plastic, of the sign of displacement; the mean of the contacts'
    ContactState state = ContactState::open;  ///< sliding if any contact slides
    JointRecord record;                       ///< of the contact that bears most
};
JointReading read_joint(const Model& model, const State& state, const MeasuredJoint& joint);

}  // namespace rockslope::dda
