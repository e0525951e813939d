#pragma once

#include "dda/solve/outer/augmentation.hpp"

namespace rockslope::dda {

/// Shifts the springs of augmented contacts at the minima of an iteration, Eq. (37), until they are rigid.
/// The penetration that remains after the last round is left to the next step.
class AugmentationRounds {
  public:
    /// @param problem, trials must outlive the rounds.
    AugmentationRounds(const StepProblem& problem, TrialContacts& trials) : p_(problem), trials_(trials) {}

    /// Shifts the springs at a minimum of the potential. @return whether any was shifted.
    bool shift() {
        if (rounds_ == round_limit || !augment(p_, trials_, mixing_)) return false;
        ++rounds_;
        return true;
    }
    /// Forgets the earlier rounds for the mixing: they were those of another active set.
    void forget() { mixing_ = AndersonMixing(memory); }

  private:
    static constexpr int round_limit = 60;
    static constexpr int memory = 10;  ///< earlier rounds that the Anderson mixing uses

    const StepProblem& p_;
    TrialContacts& trials_;
    int rounds_ = 0;
    AndersonMixing mixing_ = AndersonMixing(memory);
};

}  // namespace rockslope::dda
