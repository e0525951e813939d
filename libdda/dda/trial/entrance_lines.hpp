#pragma once

#include <vector>

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// The entrance lines of the vertex-vertex contacts of a step, of which one in each group may close.
class EntranceLines {
  public:
    /// @param problem, trials must outlive the lines.
    EntranceLines(const StepProblem& problem, TrialContacts& trials);

    /// First entrance, Eq. (28): of each group of entrance lines at a vertex-vertex contact, only the line
    /// with the largest gap at the iterate, which is crossed last, may close. Inherited penetration adds
    /// twice its depth to the gap. @return whether any line was exchanged.
    bool select_first();

  private:
    const StepProblem& p_;
    TrialContacts& trials_;
    std::vector<ContactIndex> contacts_;  ///< on lines of groups that are not inhibited
    std::vector<ContactIndex> first_;     ///< per group, on the line that may close
};

}  // namespace rockslope::dda
