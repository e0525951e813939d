#pragma once

#include "dda/path/limited_forces.hpp"

namespace rockslope::dda {

/// The way from blocks that were balanced in patches to the solution of the linear system of all blocks: a
/// damped Newton step, Eq. (101). The linear system knows only the present pieces, and throws a block far
/// whose contacts all yield there. Blocks that are thrown stay where they are, for the next patches; if that
/// does not suffice, the step of all blocks is halved until the unbalanced forces do not grow much. Memory is
/// kept from step to step.
class DampedStep {
  public:
    /// Moves the blocks towards the target. @return whether all went the whole way.
    /// @param displacement, target per row, m.
    /// @param length per row, m: moments over it are compared with forces, and rotations by it with
    /// displacements.
    /// @param tolerance N per metre; unbalanced forces below it may grow.
    bool take(const LimitedStep& step, RowSpan<const Vec6> target, RowSpan<const double> length,
              double tolerance, PerRow<Vec6>& displacement, const ThreadPool& pool);

  private:
    /// Finds how far each block goes to the target, and how far one must go to be thrown.
    void find_moves(RowSpan<const Vec6> from, RowSpan<const Vec6> target, RowSpan<const double> length);
    /// Keeps where they are the thrown blocks that are out of balance, or press on such a block.
    /// @param allowed N per metre, unbalanced force of all blocks. @return whether there are any.
    bool hold_thrown(const LimitedStep& step, double allowed);
    /// The one that moves farthest of a block and those that press on it.
    RowIndex farthest_moving(const LimitedStep& step, RowIndex row) const;
    double moved(RowIndex row) const { return part_[row] * move_[row]; }

    LimitedForces forces_;
    PerRow<Vec6> trial_;
    PerRow<double> part_;  ///< per row: of the way to the target
    PerRow<double> move_;  ///< per row: the whole way, m
    double thrown_ = 0;    ///< m, a longer way is a throw
};

}  // namespace rockslope::dda
