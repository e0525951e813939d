#pragma once

#include <vector>

#include "dda/contact/joint_segments.hpp"

namespace rockslope::dda {

/// A counter-slip of a joint segment.
struct JointCounterSlip {
    BlockIndex first, second;  ///< the two blocks, the lower index first
    JointMaterialIndex joint_material;
    Vec2 at = Vec2::Zero();  ///< m, mean of the segment's contacts
    CounterSlip slip;
};

/// The counter-slips that an accepted step ended, because the joints slipped the other way. A joint whose
/// contacts are lost takes its counter-slip with it: its reversals decide nothing any more.
/// @param before, after contacts at the start and at the end of the step.
std::vector<JointCounterSlip> ended_counter_slips(const Model& model, const JointSegments& segments,
                                                  ContactSpan<const Contact> before,
                                                  ContactSpan<const Contact> after);

/// The counter-slips that have not ended yet.
std::vector<JointCounterSlip> present_counter_slips(const Model& model, ContactSpan<const Contact> contacts);

/// Whether reversals wear the joints of any material.
bool wears_by_reversals(const Model& model);

}  // namespace rockslope::dda
