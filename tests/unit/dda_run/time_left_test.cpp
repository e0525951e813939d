#include "time_left.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace rockslope::time_left_test {
namespace {

using ::testing::Each;
using ::testing::MatchesRegex;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double odd_numbers[] = {nan, -infinity, -1e300, -1,  -1e-300, 0,       1e-300,
                                  1,   59.6,      3599.7, 1e9, 1e300,   infinity};

/// A run whose steps are given one by one.
struct FollowedRun {
    dda::Stage stage;
    dda::State state;
    dda::StepReport report;
    dda::Progress now{stage, state, report};
    TimeLeft left;

    explicit FollowedRun(dda::StageKind kind) { stage.kind = kind; }
    /// The estimate after one more step, which takes some wall time, s.
    std::optional<double> step(double wall) {
        ++state.stage_steps;
        now.wall_time += wall;
        return left.after(now);
    }
    std::optional<double> dynamic_step(double done, double wall) {
        stage.kind = dda::StageKind::dynamic;
        now.done = done;
        return step(wall);
    }
    std::optional<double> static_step(double unbalanced, double wall) {
        stage.kind = dda::StageKind::static_equilibrium;
        report.unbalanced_force = unbalanced;
        return step(wall);
    }
};

TEST(TimeLeft, TextIsATimeOrAQuestion) {
    EXPECT_EQ(time_left_text(std::nullopt), "? left");
    EXPECT_EQ(time_left_text(nan), "? left");
    EXPECT_EQ(time_left_text(-infinity), "0:00 left");
    EXPECT_EQ(time_left_text(-0.0), "0:00 left");
    EXPECT_EQ(time_left_text(59.6), "1:00 left");
    EXPECT_EQ(time_left_text(3599.4), "59:59 left");
    EXPECT_EQ(time_left_text(3599.7), "1:00:00 left");
    EXPECT_EQ(time_left_text(359'999), "99:59:59 left");
    EXPECT_EQ(time_left_text(360'000), "over 100 h left");
    EXPECT_EQ(time_left_text(infinity), "over 100 h left");
}

// Durations, forces and clocks as they should not be: a stage without a duration, a force that is no number,
// a step that takes no time.
TEST(TimeLeft, NeverSaysNonsense) {
    std::set<std::string> texts;
    const auto add = [&](const std::optional<double>& seconds) { texts.insert(time_left_text(seconds)); };
    for (const double first : odd_numbers)
        for (const double second : odd_numbers)
            for (const double goal : odd_numbers)
                for (const double wall : {0.0, 1e-9, 1.0, 1e9}) {
                    FollowedRun shaken(dda::StageKind::dynamic);
                    shaken.now.total = goal;
                    for (const double done : {first, second, second}) add(shaken.dynamic_step(done, wall));
                    FollowedRun settled(dda::StageKind::static_equilibrium);
                    settled.stage.tolerance = goal;
                    for (const double force : {first, second, second}) add(settled.static_step(force, wall));
                }
    EXPECT_GT(texts.size(), 10u);
    EXPECT_THAT(texts, Each(MatchesRegex("([0-9]+:[0-9][0-9](:[0-9][0-9])?|over 100 h|\\?) left")));
}

TEST(TimeLeft, IsThatOfASteadyRunFromTheSecondStepOn) {
    FollowedRun run(dda::StageKind::dynamic);
    run.now.total = 10;
    EXPECT_FALSE(run.dynamic_step(0.1, 5)) << "the first step includes the start of the run";
    for (int k = 2; k < 100; ++k) EXPECT_NEAR(*run.dynamic_step(0.1 * k, 0.3), 0.3 * (100 - k), 1e-9) << k;
}

// A static stage between two dynamic ones made their speed look slower, by 1000 s left instead of 15 s.
TEST(TimeLeft, OfDynamicStagesLeavesOutTheStaticOnesBetween) {
    FollowedRun run(dda::StageKind::dynamic);
    run.now.total = 10;
    for (int k = 1; k <= 50; ++k) run.dynamic_step(0.1 * k, 0.3);
    for (int k = 0; k < 100; ++k) run.static_step(1e-3, 10);
    EXPECT_NEAR(*run.dynamic_step(5.1, 0.3), 0.3 * 49, 1e-9);
}

TEST(TimeLeft, OfAStaticStageFollowsTheForce) {
    FollowedRun run(dda::StageKind::static_equilibrium);
    run.stage.tolerance = 1e-6;
    // A tenth each step, from 1 on; also when the run is resumed in the middle of the stage.
    for (const int before : {0, 1000}) {
        run.left = {};
        run.state.stage_steps = before;
        EXPECT_FALSE(run.static_step(1, 2));
        for (int k = 1; k < 6; ++k)
            EXPECT_NEAR(*run.static_step(std::pow(10, -k), 2), 2 * (6 - k), 1e-9) << k;
        EXPECT_EQ(*run.static_step(1e-7, 2), 0) << "the goal is reached";
    }
    run.state.stage_steps = 0;
    EXPECT_FALSE(run.static_step(infinity, 2)) << "the next stage begins anew";
    EXPECT_FALSE(run.static_step(1e-3, 2)) << "no number of steps leads from infinity to here";
}

TEST(TimeLeft, OfTrialsIsThatOfTheirNumber) {
    FollowedRun run(dda::StageKind::static_equilibrium);
    run.now.trial = dda::TrialProgress{1, 1, std::nullopt};
    EXPECT_FALSE(run.static_step(1, 1)) << "the factor is not bracketed";
    run.now.trial = dda::TrialProgress{2, 1.5, 3};
    EXPECT_NEAR(*run.static_step(1, 6), 3.5 * 6 / 1.5, 1e-9);
    run.now.trial = dda::TrialProgress{5, 1.2, 0};
    EXPECT_NEAR(*run.static_step(1, 12), 0.5 * 18 / 4.5, 1e-9);
}

}  // namespace
}  // namespace rockslope::time_left_test
