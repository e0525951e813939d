#pragma once

#include <vector>

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// The entrance lines of the vertex-vertex contacts of a step, of which one in each group may close.
class EntranceLines {
  public:
    /// @param trials must outlive the lines.
    EntranceLines(const StepProblem& problem, TrialContacts& trials);

    /// First entrance, Eq. (28): of each group of entrance lines at a vertex-vertex contact, only the line
    /// with the largest gap at the iterate, which is crossed last, may close. Inherited penetration adds
    /// twice its depth to the gap. @return whether any line was exchanged.
    bool select_first();

  private:
    /// A contact on a line of a group, not inhibited.
    struct Member {
        ContactIndex contact;
        int group = -1;
        int line = 0;
        double allowed = 0;  ///< m, twice its inherited penetration
    };
    /// The line of a group that may close.
    struct First {
        int line = -1;
        double gap = 0;  ///< m, with what is allowed
    };

    TrialContacts& trials_;
    std::vector<Member> members_;
    std::vector<First> first_;  ///< per group
};

}  // namespace rockslope::dda
