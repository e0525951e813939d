#pragma once

#include "dda/solve/limited_forces.hpp"

namespace rockslope::dda {

/// The way from blocks that were balanced in patches to the solution of the linear system of all blocks,
/// halved until the unbalanced forces do not grow much: a damped Newton step, Eq. (101). The linear system
/// knows only the present pieces, and throws a block far whose contacts all yield there. Memory is kept from
/// step to step.
class DampedStep {
  public:
    /// The length of the step, 1 or a half, a quarter ... of it.
    /// @param from, target displacements per row, m.
    /// @param length per row, m: moments over it are compared with forces.
    /// @param tolerance N per metre; unbalanced forces below it may grow.
    double length(const LimitedStep& step, RowSpan<const Vec6> from, RowSpan<const Vec6> target,
                  RowSpan<const double> length, double tolerance, const ThreadPool& pool);

  private:
    LimitedForces forces_;
    PerRow<Vec6> trial_;
};

}  // namespace rockslope::dda
