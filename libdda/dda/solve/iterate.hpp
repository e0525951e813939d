#pragma once

#include <algorithm>
#include <cmath>

#include "common/base/thread_pool.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// The iterate of the open-close iteration, and the solution of the linear system that it goes to. The
/// iterate may stop short of that target; the displacement that remains is kept apart, for it may be so small
/// beside the displacements that their difference would be rounding.
class Iterate {
  public:
    /// At rest. @param rows of the matrix.
    explicit Iterate(std::size_t rows) : target_(rows, Vec6::Zero()), displacement_(rows, Vec6::Zero()) {}

    /// Per row: the displacement of the iterate, m.
    RowSpan<const Vec6> displacement() const { return displacement_; }
    /// Per row: the solution of the linear system, m.
    RowSpan<const Vec6> target() const { return target_; }
    /// Whether the iterate is the target, whose forces balance.
    bool is_at_target() const { return is_at_target_; }

    /// Begins another target from the iterate. @return the target, to be solved for.
    PerRow<Vec6>& new_target() {
        target_ = displacement_;
        return target_;
    }
    /// The target, to be solved for more accurately; follow_target() moves the iterate along.
    PerRow<Vec6>& refined_target() { return target_; }
    /// Moves the iterate towards the target. @param step length, 0 to 1: all the way.
    void advance(double step) {
        const double remaining = 1 - step;
        remaining_.resize(target_.size());
        for (const RowIndex r : target_.indices())
            remaining_[r] = remaining * (target_[r] - displacement_[r]);
        is_at_target_ = remaining == 0;
        follow_target();
    }
    /// The displacement, to be moved by other means than towards the target. Then moved() or stop_here() is
    /// due.
    PerRow<Vec6>& movable() { return displacement_; }
    /// Notes that the displacement has been moved. @param to_target whether it is the target now.
    void moved(bool to_target) {
        is_at_target_ = to_target;
        remaining_.resize(target_.size());
        for (const RowIndex r : target_.indices()) remaining_[r] = target_[r] - displacement_[r];
    }
    /// Makes the iterate the target, as its forces balance.
    void stop_here() {
        target_ = displacement_;
        is_at_target_ = true;
    }
    /// Moves the iterate with the target; what remains stays the same.
    void follow_target() {
        displacement_ = target_;
        if (is_at_target_) return;
        for (const RowIndex r : target_.indices()) displacement_[r] -= remaining_[r];
    }
    /// The largest force of inertia and elasticity on a block, N per metre, for the remaining displacement.
    /// Moments and generalised strain forces are divided by the square root of the block's area.
    double remaining_force(const StepProblem& problem, const ThreadPool& pool) const {
        const auto largest_of_rows = [&](std::size_t begin, std::size_t end) {
            double largest = 0;
            for (const RowIndex r : indices<RowIndex>(begin, end)) {
                Vec6 force = problem.base.stiffness[r] * remaining_[r];
                const BlockIndex block = problem.rows.block_of[r];
                force.tail<4>() /= std::sqrt(problem.blocks.moments[block].area);
                largest = std::max(largest, force.cwiseAbs().maxCoeff());
            }
            return largest;
        };
        return pool.parallel_reduce(remaining_.size(), 0.0, largest_of_rows,
                                    [](double a, double b) { return std::max(a, b); });
    }

  private:
    PerRow<Vec6> target_;
    PerRow<Vec6> displacement_;
    PerRow<Vec6> remaining_;  ///< per row: from the iterate to the target, m
    bool is_at_target_ = true;
};

}  // namespace rockslope::dda
