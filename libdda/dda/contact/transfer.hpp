#pragma once

#include <span>
#include <vector>

#include "dda/contact/joint_segments.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Gives the contacts of a new step the states, forces and histories of the old ones.
///
/// A contact keeps its identity as (corner, edge). Where that pair is gone because the corner slid on to the
/// next edge, because the roles of the two corners at the end of an overlap changed, or because a
/// neighbouring block's face took over, the nearest old contact along the same line hands over what it
/// carried: shear force, slip and history change neither sign nor size, because the tangent turns with the
/// role. `max_displacement` bounds how far a contact point can have gone, m. Contacts nobody hands anything
/// to are fresh; in the first step of a run faces that touch are intact and locked.
/// @return the faces of the new contacts.
JointSegments transfer_contacts(const Model& model, std::span<const Contact> old, double max_displacement,
                                bool first_step, std::vector<Contact>& contacts);

}  // namespace rockslope::dda
