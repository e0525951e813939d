#pragma once

#include "dda/linear/anderson.hpp"
#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// Augmented Lagrangian update, Eq. (37): if an augmented contact violates the rigid contact conditions at
/// the iterate by more than the model's tolerance, shifts the springs so that they bear the present forces at
/// zero gap and zero shear displacement. @param mixing accelerates these updates. @return whether the springs
/// were shifted.
bool augment(const StepProblem& problem, TrialContacts& trials, AndersonMixing& mixing);

}  // namespace rockslope::dda
