#pragma once

#include <span>
#include <vector>

#include "dda/analysis/trial_contacts.hpp"

namespace dda {

/// The share of the way from a displacement to the linear system's solution at which the step's potential is
/// smallest, 0 to 1, to 1e-6; exactly 1 where the potential falls all the way.
///
/// At the solution the linear forces balance, so the potential's slope along the way is the work of what the
/// laws' forces differ from those, less what the way still to go takes from the quadratic part.
/// @param from, target per row, displacements of the step.
double line_search(const StepProblem& problem, const TrialContacts& trials, std::span<const Vec6> from,
                   std::span<const Vec6> target);

}  // namespace dda
