#pragma once

#include "dda/path/limited_contact.hpp"
#include "dda/trial/shear_bounds.hpp"

namespace rockslope::dda {

/// Sets the contacts of a step with their laws frozen at the last evaluation but for their limits: normal
/// springs at their tangents, shear bounds as lines over the normal force. The bound of a rough joint
/// segment, or of a curved envelope without cohesion, is a line through no force.
/// @param d per row, the displacement of the last evaluation. @param contacts receives one per
/// contact, then one per bolt.
void limit_contacts(const StepProblem& problem, const TrialContacts& trials, const ShearBounds& bounds,
                    RowSpan<const Vec6> d, const ThreadPool& pool, PerContact<LimitedContact>& contacts);

}  // namespace rockslope::dda
