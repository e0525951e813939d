#include "dda/solve/damped_step.hpp"

#include <algorithm>

namespace rockslope::dda {

namespace {

/// The unbalanced forces may grow so many times. The patches leave forces at their rims, and the solution of
/// all blocks spreads them: with 1 the shipped slope takes twice the iterations to settle.
constexpr double allowed_growth = 10;
/// Most halvings; the step of a sixty-fourth is taken whatever it does.
constexpr int most_halvings = 6;

}  // namespace

double DampedStep::length(const LimitedStep& step, RowSpan<const Vec6> from, RowSpan<const Vec6> target,
                          RowSpan<const double> length, double tolerance, const ThreadPool& pool) {
    forces_.evaluate(step, from, length, pool);
    const double allowed = std::max(allowed_growth * forces_.norm(), tolerance);
    trial_.resize(from.size());
    double part = 1;
    for (int halvings = 0; halvings < most_halvings; ++halvings) {
        for (const RowIndex row : trial_.indices())
            trial_[row] = from[row] + part * (target[row] - from[row]);
        forces_.evaluate(step, trial_, length, pool);
        if (forces_.norm() <= allowed) break;
        part /= 2;
    }
    return part;
}

}  // namespace rockslope::dda
