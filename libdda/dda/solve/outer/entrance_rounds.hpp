#pragma once

#include "dda/trial/entrance_lines.hpp"

namespace rockslope::dda {

/// Chooses the first entrances, Eq. (28), in the course of an iteration: at each of the first iterates, later
/// only at minima of the potential and not for ever, since a line that is exchanged to and fro keeps the
/// patches from settling.
class EntranceRounds {
  public:
    /// @param lines must outlive the rounds.
    explicit EntranceRounds(EntranceLines& lines) : lines_(lines) {}

    /// Follows an iterate. @param iteration its number since the restart, from 1.
    /// @param is_at_minimum is asked only where the answer matters.
    template <class IsAtMinimum>
    void follow(int iteration, const IsAtMinimum& is_at_minimum) {
        if (iteration <= first_iterations) {
            lines_.select_first();
        } else if (rounds_ < round_limit && is_at_minimum()) {
            if (lines_.select_first()) ++rounds_;
        }
    }

    /// Number of iterations in which first entrances and gaps follow every iterate.
    static constexpr int first_iterations = 4;

  private:
    /// Number of times that lines are exchanged at later minima.
    static constexpr int round_limit = 4;
    EntranceLines& lines_;
    int rounds_ = 0;
};

}  // namespace rockslope::dda
