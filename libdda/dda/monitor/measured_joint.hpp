#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Displacements and stresses of a joint as a laboratory would measure them, SI. Displacements are zeroed
/// with those of measured points. Forces are summed over the contacts between the blocks of the two faces
/// along this joint.
struct JointReading {
    double displacement = 0;   ///< m, shear with its elastic part; positive: rock above moves right
    double dilation = 0;       ///< m, opening of the joint
    double shear_stress = 0;   ///< Pa, over the length in contact; positive against positive displacement
    double normal_stress = 0;  ///< Pa, compression positive
    double strength = 0;       ///< Pa, the smaller of the strengths in both directions
    double slip = 0;           ///< m, plastic shear displacement, mean of the contacts
    ContactState state = ContactState::open;  ///< sliding if any contact slides
    JointRecord record;                       ///< of the contact with the largest normal force
};
JointReading read_joint(const Model& model, const State& state, const MeasuredJoint& joint);

}  // namespace rockslope::dda
