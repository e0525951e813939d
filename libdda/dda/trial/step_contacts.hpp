#pragma once

#include <utility>

#include "dda/trial/entrance_lines.hpp"
#include "dda/trial/joint_dilation.hpp"
#include "dda/trial/shear_bounds.hpp"
#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// The contacts of a step during the open-close iteration, with what sets the values that it holds.
struct StepContacts {
    /// @param problem must outlive the contacts. @param memory see TrialContacts
    StepContacts(const StepProblem& problem, const ThreadPool& pool, PerContact<ContactTrial> memory = {})
        : trials(problem, pool, std::move(memory)),
          bounds(problem, trials, pool),
          dilation(problem, trials),
          entrances(problem, trials) {}
    StepContacts(const StepContacts&) = delete;
    StepContacts& operator=(const StepContacts&) = delete;

    TrialContacts trials;
    ShearBounds bounds;
    JointDilation dilation;
    EntranceLines entrances;
};

}  // namespace rockslope::dda
