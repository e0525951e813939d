#pragma once

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// Breaks, for the rest of the step, the bonds whose tension at the iterate exceeds the strength, unless
/// bonds hold. @return whether any broke.
inline bool break_bonds(const StepProblem& problem, TrialContacts& trials) {
    if (problem.bonds_hold()) return false;
    return trials.for_any([&](ContactIndex k) {
        const bool breaks = trials.is_bonded(k) && trials.law_forces(k).normal < -trials[k].bounds.tensile;
        trials[k].bond_broken = trials[k].bond_broken || breaks;
        return breaks;
    });
}

}  // namespace rockslope::dda
