#include "dda/path/damped_step.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::dda {

namespace {

/// The unbalanced forces may grow so many times. The patches leave forces at their rims, and the solution of
/// all blocks spreads them: with 1 the shipped slope takes twice the iterations to settle.
constexpr double allowed_growth = 10;
/// Most halvings; the step of a sixty-fourth is taken whatever it does.
constexpr int most_halvings = 6;
/// A block is thrown that goes farther, by this factor, than all blocks do on average, by area. A slope with
/// cohesion settles in 34 steps with 5 and in 21 with 10; with 100 ten of its steps go astray instead of
/// four.
constexpr double throw_ratio = 10;
/// Most rounds in which thrown blocks are held. A block may throw others when it is held.
constexpr int hold_rounds = 6;
/// Share of the allowed unbalanced force above which a block is out of balance.
constexpr double out_of_balance = 0.5;

}  // namespace

bool DampedStep::take(const LimitedStep& step, RowSpan<const Vec6> target, RowSpan<const double> length,
                      double tolerance, PerRow<Vec6>& displacement, const ThreadPool& pool) {
    forces_.evaluate(step, displacement, length, pool);
    const double allowed = std::max(allowed_growth * forces_.norm(), tolerance);
    find_moves(displacement, target, length);
    trial_.resize(displacement.size());
    int halvings = 0;
    for (int round = 0;; ++round) {
        for (const RowIndex row : trial_.indices())
            trial_[row] = target[row] - (1 - part_[row]) * (target[row] - displacement[row]);
        if (halvings == most_halvings) break;
        forces_.evaluate(step, trial_, length, pool);
        if (forces_.norm() <= allowed) break;
        if (round < hold_rounds && hold_thrown(step, allowed)) continue;
        for (double& part : part_) part /= 2;
        ++halvings;
    }
    displacement.swap(trial_);
    return std::all_of(part_.begin(), part_.end(), [](double part) { return part == 1; });
}

void DampedStep::find_moves(RowSpan<const Vec6> from, RowSpan<const Vec6> target,
                            RowSpan<const double> length) {
    part_.assign(from.size(), 1);
    move_.resize(from.size());
    double area = 0, squares = 0;
    for (const RowIndex row : move_.indices()) {
        Vec6 move = target[row] - from[row];
        move.tail<4>() *= length[row];
        move_[row] = move.norm();
        area += length[row] * length[row];
        squares += length[row] * length[row] * move.squaredNorm();
    }
    thrown_ = throw_ratio * std::sqrt(squares / area);
}

bool DampedStep::hold_thrown(const LimitedStep& step, double allowed) {
    bool any = false;
    for (const RowIndex row : part_.indices()) {
        if (!(forces_.unbalanced(row).cwiseAbs().maxCoeff() > out_of_balance * allowed)) continue;
        const RowIndex farthest = farthest_moving(step, row);
        if (!(moved(farthest) > thrown_)) continue;
        part_[farthest] = 0;
        any = true;
    }
    return any;
}

RowIndex DampedStep::farthest_moving(const LimitedStep& step, RowIndex row) const {
    RowIndex farthest = row;
    for (const ContactIndex k : step.row_contacts.of(row)) {
        const LimitedContact& contact = step.contacts[k];
        if (!contact.may_close || !(forces_.elastic()[k].normal > contact.least_normal)) continue;
        const RowIndex other = contact.rows->first == row ? contact.rows->second : contact.rows->first;
        if (other.exists() && moved(other) > moved(farthest)) farthest = other;
    }
    return farthest;
}

}  // namespace rockslope::dda
