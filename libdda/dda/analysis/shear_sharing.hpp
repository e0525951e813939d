#pragma once

#include "dda/contact/contact.hpp"
#include "dda/contact/joint_segments.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// Shares the shear force and the shear spring of each joint segment among its contacts in proportion to
/// their normal forces, Eq. (81), so that all of them yield together. The contacts of a segment lie on one
/// line: neither the force on a block nor its moment changes. Augmented contacts, and those of a segment
/// without a normal force, have shares by length. Contacts that have just become one segment continue one
/// history, see continued_history().
void share_shear_force(const Model& model, const JointSegments& segments, ContactSpan<Contact> contacts);

}  // namespace rockslope::dda
