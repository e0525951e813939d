#include "dda/analysis/run_stage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::run_stage_test {
namespace {

using namespace scene;
using dda::RunStatus;
using testing::DoubleNear;
using testing::HasSubstr;
using testing::Pointwise;

/// Runs stages of a scene and records the step reports.
struct StageRun : dda::RunObserver {
    dda::Model model;
    dda::State state;
    dda::TimeStepper stepper;
    std::vector<dda::StepReport> reports;
    std::size_t stop_after = 1000000;

    explicit StageRun(const Scene& s) : model(s.model), state(dda::initial_state(model)), stepper(model, 1) {}
    bool step_done(const dda::Model&, const dda::State&, const dda::Stage&,
                   const dda::StepReport& report) override {
        reports.push_back(report);
        return reports.size() < stop_after;
    }
    dda::RunOutcome run(const dda::Stage& stage) {
        dda::begin_stage(state);
        return dda::run_stage(model, stage, stepper, state, *this);
    }
    std::vector<double> times() const {
        std::vector<double> all;
        for (const dda::StepReport& report : reports) all.push_back(report.time);
        return all;
    }
    std::vector<double> steps() const {
        std::vector<double> all;
        for (const dda::StepReport& report : reports) all.push_back(report.step);
        return all;
    }
};

Scene one_block() {
    Scene s;
    s.box({0, 0}, 1, 1);
    return s;
}

dda::Stage stage_of(double duration, double step) {
    dda::Stage stage;
    stage.name = "shake";
    stage.duration = duration;
    stage.control.step = step;
    stage.control.displacement_ratio = 1;
    return stage;
}

// Steps end on the multiples of the stage's step. The end is half a step beyond the last multiple: it
// takes its place, and two equal steps lead there, so that none is very small.
TEST(RunStage, StepsEndOnMultiplesOfTheStepAndAtTheEnd) {
    StageRun run(one_block());
    ASSERT_EQ(run.run(stage_of(0.0108, 2e-3)).status, RunStatus::completed);
    EXPECT_THAT(run.times(), Pointwise(DoubleNear(1e-12), {0.002, 0.004, 0.006, 0.008, 0.0094, 0.0108}));
    EXPECT_NEAR(run.state.stage_time, 0.0108, 1e-15);
    EXPECT_EQ(run.state.stage_steps, 6);
}

TEST(RunStage, BeginsWhereTheBlocksAre) {
    StageRun run(one_block());
    run.state.stage_time = 5;
    run.state.next_step = 1;
    run.state.stage_steps = 7;
    run.state.blocks.moments[0].centroid = {3, 4};
    dda::begin_stage(run.state);
    EXPECT_EQ(run.state.stage_time, 0);
    EXPECT_EQ(run.state.next_step, 0);
    EXPECT_EQ(run.state.stage_steps, 0);
    ASSERT_EQ(run.state.stage_origin.size(), 1u);
    EXPECT_EQ(run.state.stage_origin[0], Vec2(3, 4));
}

// A block at 10 m/s may move by 5 mm in a step: 2 ms are too long, 2/3 ms are not too long by much, 2/9 ms
// fit. From there the step grows by 1.3 until the limit cuts it again.
TEST(RunStage, CutsTheStepAndLetsItGrow) {
    Scene s = one_block();
    s.model.gravity.setZero();
    StageRun run(s);
    run.state.blocks.velocity[0][0] = 10;
    dda::Stage stage = stage_of(0.2, 2e-3);
    stage.control.displacement_ratio = 0.005 / 0.5;
    run.stop_after = 3;
    EXPECT_EQ(run.run(stage).status, RunStatus::stopped);
    ASSERT_EQ(run.reports.size(), 3u);
    EXPECT_EQ(run.reports[0].cuts, 2);
    EXPECT_NEAR(run.reports[0].step, 2e-3 / 9, 1e-15);
    EXPECT_NEAR(run.reports[1].step, 2e-3 / 9, 1e-15) << "a step that was cut does not grow";
    EXPECT_NEAR(run.reports[2].step, 1.3 * 2e-3 / 9, 1e-15);
    EXPECT_EQ(run.reports[1].cuts, 0);
    EXPECT_NEAR(run.state.next_step, 1.3 * 1.3 * 2e-3 / 9, 1e-15) << "to resume from";
    EXPECT_GT(run.reports[0].iterations, run.reports[1].iterations) << "those of rejected steps count";
}

// Eq. (41): a static stage begins with a tenth of its step and grows by 1.3 up to 50 times the step as long
// as no vertex moves farther than a body falls from rest in the step. A falling block does, from there on.
TEST(RunStage, AStaticStageBeginsWithATenthOfItsStep) {
    StageRun run(one_block());
    dda::Stage stage = stage_of(0, 1e-3);
    stage.kind = dda::StageKind::static_equilibrium;
    run.stop_after = 20;
    EXPECT_EQ(run.run(stage).status, RunStatus::stopped);
    double expected = 1e-4;
    for (const double step : run.steps()) {
        EXPECT_NEAR(step, expected, 1e-12);
        expected = std::min(1.3 * expected, 1e-3);
    }
}

// A block at rest on the floor's springs does not move: the step of the stage is exceeded.
TEST(RunStage, AStaticStageLengthensItsStepWhereNothingMoves) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    StageRun run(s);
    dda::Stage stage = stage_of(0, 1e-3);
    stage.kind = dda::StageKind::static_equilibrium;
    stage.tolerance = 0;
    stage.step_limit = 60;
    EXPECT_EQ(run.run(stage).status, RunStatus::not_settled);
    EXPECT_NEAR(run.steps().back(), 50e-3, 1e-9);
}

TEST(RunStage, AStaticStageEndsAtRest) {
    Scene s;
    s.box({-1, -1}, 3, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    StageRun run(s);
    dda::Stage stage = stage_of(0, 5e-3);
    stage.kind = dda::StageKind::static_equilibrium;
    stage.tolerance = 1e-6;
    ASSERT_EQ(run.run(stage).status, RunStatus::completed);
    for (std::size_t k = 0; k + 1 < run.reports.size(); ++k)
        EXPECT_GT(run.reports[k].unbalanced_force, 1e-6) << "it would have ended before";
    EXPECT_LE(run.reports.back().unbalanced_force, 1e-6);
    EXPECT_EQ(run.state.blocks.velocity[1], Vec6::Zero());
    EXPECT_EQ(run.state.blocks.acceleration[1], Vec6::Zero());
    EXPECT_EQ(run.state.dynamic_time, 0);
}

TEST(RunStage, SaysWhichBlockDoesNotSettle) {
    StageRun run(one_block());
    dda::Stage stage = stage_of(0, 5e-3);
    stage.kind = dda::StageKind::static_equilibrium;
    stage.displacement_limit = 1e-3;
    const dda::RunOutcome moved = run.run(stage);
    EXPECT_EQ(moved.status, RunStatus::not_settled);
    EXPECT_THAT(moved.message, HasSubstr("stage 'shake' does not settle: block 0 at (0.5, "));
    EXPECT_THAT(moved.message, HasSubstr("in free fall"));
    EXPECT_GT(-run.state.blocks.centroid(0).y() + 0.5, 1e-3);

    StageRun limited(one_block());
    stage.displacement_limit = 1e9;
    stage.step_limit = 4;
    const dda::RunOutcome many = limited.run(stage);
    EXPECT_EQ(many.status, RunStatus::not_settled);
    EXPECT_THAT(many.message, HasSubstr("after 4 steps block 0"));
    EXPECT_EQ(limited.reports.size(), 4u);
}

/// A block at rest on a floor, and a chip of 1e-6 of its mass in the air.
Scene block_and_falling_chip() {
    Scene s;
    s.box({-1, -1}, 12, 1, dda::Motion::fixed);
    s.box({0, 0}, 10, 10);
    s.box({50, 0}, 0.01, 0.01);
    return s;
}

TEST(RunStage, AStaticStageRestsWhileAChipMoves) {
    dda::Stage stage = stage_of(0, 5e-3);
    stage.kind = dda::StageKind::static_equilibrium;
    stage.displacement_limit = 1e-4;
    StageRun run(block_and_falling_chip());
    ASSERT_EQ(run.run(stage).status, RunStatus::completed);
    EXPECT_TRUE(run.reports.back().at_rest);
    EXPECT_EQ(run.state.blocks.acceleration[1], Vec6::Zero());
    EXPECT_NEAR(run.state.blocks.acceleration[2][1], -g, 1e-9 * g) << "it goes on falling";
    EXPECT_EQ(run.state.blocks.velocity[2], Vec6::Zero());

    stage.moving_share = 0;
    StageRun strict(block_and_falling_chip());
    const dda::RunOutcome outcome = strict.run(stage);
    EXPECT_EQ(outcome.status, RunStatus::not_settled);
    EXPECT_THAT(outcome.message, HasSubstr("block 2 at"));
}

TEST(RunStage, SaysWhyNoStepIsAccepted) {
    StageRun run(one_block());
    run.state.blocks.velocity[0][0] = 10;
    dda::Stage stage = stage_of(0.1, 2e-3);
    stage.control.displacement_ratio = 0.005 / 0.5;
    stage.control.smallest_step = 1e-3;
    const dda::RunOutcome outcome = run.run(stage);
    EXPECT_EQ(outcome.status, RunStatus::not_converged);
    EXPECT_EQ(outcome.message,
              "stage 'shake', t = 0 s: no step above 0.001 s is accepted: a vertex moves 0.02 m in one step");
    EXPECT_EQ(run.state.time, 0);
    EXPECT_EQ(run.state.blocks.velocity[0][0], 10) << "the last accepted state";
}

/// A block at 1 m/s, which may move by so much in a step (m).
dda::RunOutcome flight(double largest_displacement, StageRun& run) {
    run.state.blocks.velocity[dda::BlockIndex(0)][0] = 1;
    dda::Stage stage = stage_of(1e-3, 1e-3);
    stage.control.displacement_ratio = largest_displacement / 0.5;  // over the half-height
    return run.run(stage);
}

TEST(RunStage, EndsWhereItCrawls) {
    StageRun run(one_block());
    const dda::RunOutcome outcome = flight(0.5e-7, run);
    EXPECT_EQ(outcome.status, RunStatus::not_converged);
    EXPECT_THAT(outcome.message, HasSubstr("the last 2000 steps were each below 0.0001 of the stage's step"));
    EXPECT_THAT(outcome.message, HasSubstr("a vertex moves"));
    EXPECT_EQ(run.reports.size(), 2000);
}

TEST(RunStage, GoesOnInShortSteps) {
    StageRun run(one_block());
    EXPECT_EQ(flight(4e-7, run).status, RunStatus::completed);
    EXPECT_GT(run.reports.size(), 2000);
}

}  // namespace
}  // namespace rockslope::run_stage_test
