#include "dda/analysis/line_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/first_step.hpp"

namespace {

using namespace scene;

/// A wall somewhere on its way.
struct MovingWall {
    FirstStep step;
    dda::StepProblem problem = step.problem();
    dda::TrialContacts trials{problem, step.crew};
    std::vector<Vec6> from;

    explicit MovingWall(Dice& dice) : from(moved(dice, step.rows.count(), 2)) {
        trials.move_to(from, from);
        trials.choose_lines();
        trials.update_bounds();
        trials.choose_springs();
        trials.force_change();  // sets what counts as converged
    }
    /// The potential's slope after a share of the way, as the header has it.
    double slope(const std::vector<Vec6>& target, double share) const {
        double sum = 0;
        std::vector<Vec6> d(target.size());
        std::vector<Vec6> way(target.size());
        for (std::size_t r = 0; r < d.size(); ++r) {
            way[r] = target[r] - from[r];
            d[r] = from[r] + share * way[r];
            sum -= (1 - share) * way[r].dot(step.base.stiffness[r] * way[r]);
        }
        for (std::size_t k = 0; k < trials.count(); ++k) {
            const dda::ContactSprings& s = step.springs[k];
            const auto measure = [&](const dda::Relative& relative, const std::vector<Vec6>& at) {
                return s.rows.measure(relative, at);
            };
            const dda::Forces law = trials.law_forces(k, measure(s.normal, d), measure(s.shear, d));
            const dda::Forces linear =
                trials.linear_forces(k, measure(s.normal, target), measure(s.shear, target));
            sum += (linear.normal - law.normal) * (measure(s.normal, way) - s.normal.known) +
                   (law.shear - linear.shear) * (measure(s.shear, way) - s.shear.known);
        }
        return sum;
    }
};

TEST(LineSearch, FindsWhereTheSlopePassesZero) {
    Dice dice(7);
    int inside = 0;
    for (int round = 0; round < 40; ++round) {
        const MovingWall wall(dice);
        std::vector<Vec6> target = moved(dice, wall.step.rows.count(), 1 + dice.one_of(3));
        for (Vec6& of_row : target) of_row *= std::pow(10, dice.one_of(4)) / 10;
        dda::LineSearch search(wall.problem, wall.trials, wall.step.crew);
        const double share = search.share(wall.from, target);
        ASSERT_GT(share, 0);
        ASSERT_LE(share, 1);
        if (share == 1) {
            EXPECT_LE(wall.slope(target, 1), 0);
            continue;
        }
        ++inside;
        EXPECT_GT(wall.slope(target, share), 0) << "round " << round;
        EXPECT_LE(wall.slope(target, std::max(share - 1.1e-6, 0.0)), 0) << "round " << round;
    }
    EXPECT_GT(inside, 10);
}

TEST(LineSearch, GivesTheSameBitsWithAnyNumberOfThreads) {
    Dice dice(8);
    const MovingWall wall(dice);
    const std::vector<Vec6> target = moved(dice, wall.step.rows.count(), 1);
    const auto share = [&](int threads) {
        const dda::Crew crew(threads);
        return dda::LineSearch(wall.problem, wall.trials, crew).share(wall.from, target);
    };
    for (const int threads : {2, 3}) EXPECT_EQ(share(threads), share(1)) << threads;
}

}  // namespace
