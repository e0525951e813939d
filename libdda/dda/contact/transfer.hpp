#pragma once

#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/contact/joint_segments.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Contact transfer: gives the contacts of a step the states, forces and histories of their predecessors in
/// the last step.
///
/// A contact is identified by (corner, edge). If that pair is gone, the nearest old contact on the same line
/// is the predecessor. The pair changes when the corner slides onto the next edge or onto a neighbouring
/// block's face, or when the two corners at the end of an overlap exchange roles. The tangent turns with the
/// roles, so shear force, slip and history keep sign and size. A contact without predecessor starts open and
/// unbonded; in the first step of a run a contact of touching faces starts locked and intact, Eq. (30).
/// @param old contacts at the end of the last step, in the order of comes_before.
/// @param max_displacement m, largest distance between a contact and its predecessor.
/// @param contacts detected contacts, in the order of comes_before; their states are set.
/// @return the joint segments of the new contacts.
JointSegments transfer_contacts(const Model& model, ContactSpan<const Contact> old, double max_displacement,
                                bool first_step, std::vector<Contact>& contacts, const ThreadPool& pool);

}  // namespace rockslope::dda
