#pragma once

#include "dda/trial/joint_dilation.hpp"

namespace rockslope::dda {

/// Updates the dilation in the course of an iteration: at every iterate at first, then at minima of the
/// potential. It depends on the displacement and on the normal force that it causes itself. With many joints
/// it may not converge within a step; then the rest acts in the next step, and where friction would give
/// energy the dilation is limited.
class DilationRounds {
  public:
    /// @param dilation must outlive the rounds.
    explicit DilationRounds(JointDilation& dilation) : dilation_(dilation) {}

    /// Follows an iterate. @param iteration its number in the step, from 1.
    void follow(int iteration) {
        if (follows(iteration)) dilation_.update();
    }
    /// Whether the dilation follows an iterate.
    static bool follows(int iteration) { return iteration <= first_iterations; }
    /// Updates the dilation at a minimum of the potential. @return whether any changed.
    bool update_at_minimum() {
        const bool may_update = ++minima_ <= minimum_limit;
        if (may_update && dilation_.exceeds_tolerance()) {
            dilation_.update();
            return true;
        }
        if (!may_update && dilation_.postpone()) return true;
        return limits_++ < limit_rounds && dilation_.limit();
    }
    /// Counts the minima anew, since the springs of the step have changed.
    void restart() { minima_ = 0; }

  private:
    static constexpr int first_iterations = 4;  ///< in which it follows every iterate
    static constexpr int minimum_limit = 2;     ///< minima at which it is updated after these
    static constexpr int limit_rounds = 3;      ///< minima of a step at which it is limited

    JointDilation& dilation_;
    int minima_ = 0;
    int limits_ = 0;
};

}  // namespace rockslope::dda
