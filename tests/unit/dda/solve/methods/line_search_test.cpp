#include "dda/solve/methods/line_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dda/trial/step_contacts.hpp"
#include "support/first_step.hpp"

namespace rockslope::line_search_test {
namespace {

using namespace scene;

/// The first step of a wall at a random displacement, from which the line search starts.
struct MovingWall {
    FirstStep step;
    dda::PerContact<dda::NormalDashpot> dashpots;
    dda::StepProblem problem = step.problem();
    dda::StepContacts contacts{problem, step.pool};
    dda::TrialContacts& trials = contacts.trials;
    std::vector<Vec6> from;

    /// @param damping stiffness of the dashpots over that of the springs.
    explicit MovingWall(RandomSource& random, double damping = 0,
                        const dda::JointLaw& law = Scene::mohr_coulomb(35))
        : step(law), from(moved(random, step.rows.count(), 2)) {
        if (damping > 0) {
            for (const dda::ContactSprings& s : step.springs)
                dashpots.push_back({damping * s.normal_stiffness, 3e-5, 1});
            problem.dashpots = dashpots;
        }
        trials.set_displacement(from, from);
        contacts.entrances.select_first();
        contacts.bounds.update();
        trials.update_active_set();
        trials.force_change();  // sets the largest force, which scales the tolerance
    }
    /// The directional derivative of the potential at a step length, computed directly from the formula in
    /// line_search.hpp.
    double slope(const std::vector<Vec6>& target, double step_length) const {
        double sum = 0;
        std::vector<Vec6> d(target.size());
        std::vector<Vec6> direction(target.size());
        for (std::size_t r = 0; r < d.size(); ++r) {
            direction[r] = target[r] - from[r];
            d[r] = from[r] + step_length * direction[r];
            sum -= (1 - step_length) * direction[r].dot(step.base.stiffness[r] * direction[r]);
        }
        for (std::size_t k = 0; k < trials.count(); ++k) {
            const dda::ContactSprings& s = step.springs[k];
            const auto measure = [&](const dda::RelativeMeasure& relative, const std::vector<Vec6>& at) {
                return s.rows.measure(relative, at);
            };
            const dda::Forces law = trials.law(k).forces(measure(s.normal, d), measure(s.shear, d));
            const dda::Forces linear =
                trials.linear_forces(k, measure(s.normal, target), measure(s.shear, target));
            sum += (linear.normal - law.normal) * (measure(s.normal, direction) - s.normal.prescribed) +
                   (law.shear - linear.shear) * (measure(s.shear, direction) - s.shear.prescribed);
        }
        return sum;
    }
};

/// @param damping, law see MovingWall.
void expect_zero_of_the_slope(double damping, const dda::JointLaw& law = Scene::mohr_coulomb(35)) {
    RandomSource random(7);
    int inside = 0;
    for (int round = 0; round < 40; ++round) {
        const MovingWall wall(random, damping, law);
        std::vector<Vec6> target = moved(random, wall.step.rows.count(), 1 + random.index_below(3));
        for (Vec6& of_row : target) of_row *= std::pow(10, random.index_below(4)) / 10;
        dda::LineSearch search(wall.problem, wall.trials, wall.step.pool);
        const double step_length = search.step_length(wall.from, target);
        ASSERT_GT(step_length, 0);
        ASSERT_LE(step_length, 1);
        if (step_length == 1) {
            EXPECT_LE(wall.slope(target, 1), 0);
            continue;
        }
        ++inside;
        EXPECT_GT(wall.slope(target, step_length), 0) << "round " << round;
        EXPECT_LE(wall.slope(target, std::max(step_length - 1.1e-6, 0.0)), 0) << "round " << round;
    }
    EXPECT_GT(inside, 10);
}

TEST(LineSearch, FindsTheZeroOfTheSlope) {
    expect_zero_of_the_slope(0);
}

// Dashpots add to the stiffness of compressed springs, and pull where they expand.
TEST(LineSearch, FindsTheZeroOfTheSlopeWithDashpots) {
    expect_zero_of_the_slope(0.3);
    expect_zero_of_the_slope(3);
}

// Where a bound hardens a sliding contact has a stiffness, too.
TEST(LineSearch, FindsTheZeroOfTheSlopeWithBoundsThatHarden) {
    expect_zero_of_the_slope(0, dda::ContinuouslyYielding{radians(35), radians(25), 1e-3});
}

TEST(LineSearch, IsBitwiseTheSameForAnyNumberOfThreads) {
    RandomSource random(8);
    const MovingWall wall(random);
    const std::vector<Vec6> target = moved(random, wall.step.rows.count(), 1);
    const auto step_length = [&](int threads) {
        const ThreadPool pool(threads);
        return dda::LineSearch(wall.problem, wall.trials, pool).step_length(wall.from, target);
    };
    for (const int threads : {2, 3}) EXPECT_EQ(step_length(threads), step_length(1)) << threads;
}

}  // namespace
}  // namespace rockslope::line_search_test
