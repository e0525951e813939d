#pragma once

#include "dda/linear/anderson.hpp"
#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// Shifts the springs of augmented contacts at the minima of an iteration, Eq. (37), until they are rigid.
/// The penetration that remains after the last round is left to the next step.
class AugmentationRounds {
  public:
    /// @param trials the contacts of the iteration.
    explicit AugmentationRounds(TrialContacts& trials) : trials_(trials) {}

    /// Shifts the springs at a minimum of the potential. @return whether any was shifted.
    bool shift() {
        if (rounds_ == round_limit || !trials_.augment(mixing_)) return false;
        ++rounds_;
        return true;
    }
    /// Forgets the earlier rounds for the mixing: they were those of another active set.
    void forget() { mixing_ = AndersonMixing(memory); }

  private:
    static constexpr int round_limit = 60;
    static constexpr int memory = 10;  ///< earlier rounds that the Anderson mixing uses

    TrialContacts& trials_;
    int rounds_ = 0;
    AndersonMixing mixing_ = AndersonMixing(memory);
};

}  // namespace rockslope::dda
