#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Displacements and stresses of a joint as a laboratory would measure them, SI. Displacements are zeroed
/// with those of measured points. Forces are summed over the contacts between the blocks of the two faces
/// along this joint.
struct JointReading {
    double displacement = 0;  ///< m, shear with its elastic part; positive: rock above moves right
    double dilation = 0;      ///< m, opening of the joint
    /// Pa, over the length that bears: that of the closed contacts. Positive against positive displacement.
    double shear_stress = 0;
    double normal_stress = 0;  ///< Pa, over the length that bears, compression positive
    double strength = 0;       ///< Pa, over that length, the smaller of the strengths in both directions
    double shear_stress_over_joint = 0;       ///< Pa, over the whole joint, see joint_length()
    double normal_stress_over_joint = 0;      ///< Pa, over the whole joint
    double slip = 0;                          ///< m, plastic shear displacement, mean of the contacts
    ContactState state = ContactState::open;  ///< sliding if any contact slides
    JointRecord record;                       ///< of the contact with the largest normal force
};

/// The length of a measured joint, m: of the shorter of the two faces that meet there, before any block
/// moves. Collinear edges of a block are one face. A block that has slid over an edge bears on a part of it.
double joint_length(const Model& model, const MeasuredJoint& joint);

JointReading read_joint(const Model& model, const State& state, const MeasuredJoint& joint);

}  // namespace rockslope::dda
