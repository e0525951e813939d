#pragma once

#include "dda/trial/segment_strength.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// The strength of a contact that shares no joint segment, divided by the model's strength reduction, N per
/// metre: shear bounds and tensile strength. Where bonds hold, the share of its bond that yields is left out,
/// Eq. (97). @param loading of the contact at the step's end.
Strength single_strength(const StepProblem& problem, ContactIndex contact, const ContactLoading& loading);

}  // namespace rockslope::dda
