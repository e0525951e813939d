#include "dda/analysis/stop_limit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dda/analysis/run_stage.hpp"
#include "support/scene.hpp"

namespace rockslope::stop_limit_test {
namespace {

using namespace scene;
using dda::RunStatus;
using testing::HasSubstr;

/// Two blocks in the air, the second ten thousand times lighter, and a base far below.
Scene falling_blocks() {
    Scene s;
    s.box({-50, -200}, 100, 1, dda::Motion::prescribed, 0, "base");
    s.box({0, 0}, 1, 1);
    s.box({5, 0}, 0.01, 0.01);
    s.model.measured_points.push_back({"top", s.material_point(1, {0.5, 1})});
    return s;
}

dda::Stage falling(double limit) {
    dda::Stage stage;
    stage.name = "fall";
    stage.duration = 2;
    stage.control.step = 0.01;
    stage.control.displacement_ratio = 1;
    stage.stop = dda::StopLimit{};
    stage.stop->displacement = limit;
    return stage;
}

struct Fall : dda::RunObserver {
    dda::Model model;
    dda::State state;
    bool failed = false;
    int stop_after = 1000000;

    explicit Fall(const Scene& s) : model(s.model), state(dda::initial_state(model)) {}
    bool step_done(const dda::Model&, const dda::State&, const dda::Stage&, const dda::StepReport&) override {
        return --stop_after > 0;
    }
    void stage_fails(const dda::Model&, const dda::State&, const dda::Stage&, int) override { failed = true; }
    dda::RunOutcome run(const dda::Stage& stage, const dda::RunOptions& options = {}) {
        return dda::run(model, std::vector{stage}, state, *this, options);
    }
};

// A body falls 1 m in sqrt(2/g) = 0.4515 s: the step that ends at 0.46 s is the first beyond it.
TEST(StopLimit, EndsTheStageWithTheStepThatPassesIt) {
    Fall run(falling_blocks());
    const dda::RunOutcome outcome = run.run(falling(1));
    ASSERT_EQ(outcome.status, RunStatus::collapsed);
    EXPECT_TRUE(run.failed) << "the observer keeps the frame";
    ASSERT_TRUE(outcome.collapse);
    EXPECT_NEAR(outcome.collapse->time, 0.46, 0.011);
    EXPECT_GT(outcome.collapse->displacement, 1);
    EXPECT_LT(outcome.collapse->displacement, 1.1);
    EXPECT_NEAR(outcome.collapse->at.y(), 0.5 - outcome.collapse->displacement, 0.6);
    EXPECT_THAT(outcome.message, HasSubstr("stage 'fall' has collapsed, t = "));
    EXPECT_THAT(outcome.message, HasSubstr("in free fall, beyond the limit of 1 m, and does not stop"));
}

TEST(StopLimit, IsNotPassedByAChip) {
    Scene s = falling_blocks();
    s.model.motion[1] = dda::Motion::fixed;
    dda::Stage stage = falling(0.5);
    EXPECT_EQ(Fall(s).run(stage).status, RunStatus::collapsed);
    s = falling_blocks();
    s.model.initial_velocity.assign(3, Vec6::Zero());
    s.model.initial_velocity[2][0] = 10;
    stage.duration = 0.2;
    EXPECT_EQ(Fall(s).run(stage).collapse->block, 2);
    stage.stop->share = 1e-3;
    EXPECT_EQ(Fall(s).run(stage).status, RunStatus::completed);
}

TEST(StopLimit, WatchesAPointOrARegion) {
    Scene s = falling_blocks();
    s.model.initial_velocity.assign(3, Vec6::Zero());
    s.model.initial_velocity[2][0] = 20;
    dda::Stage stage = falling(0.5);
    EXPECT_EQ(Fall(s).run(stage).collapse->block, 2) << "the fastest block";
    stage.stop->watched = "body";
    stage.stop->blocks = {1};
    EXPECT_EQ(Fall(s).run(stage).collapse->block, 1);
    stage.stop->watched = "top";
    stage.stop->point = s.model.measured_points[0].point;
    const dda::RunOutcome outcome = Fall(s).run(stage);
    EXPECT_EQ(outcome.collapse->block, 1);
    EXPECT_EQ(outcome.collapse->point, "top");
    EXPECT_THAT(outcome.message, HasSubstr("point 'top' of block 1 at (0.5, "));
}

// The base rises as fast as a body falls: relative to it the block moves twice as far.
TEST(StopLimit, SubtractsTheMotionOfTheReference) {
    Scene s = falling_blocks();
    dda::Stage stage = falling(1);
    stage.base_motions.push_back({"base", {{0.0}, {0.0}}, {{0.0, 2.0}, {g, g}}});
    EXPECT_NEAR(Fall(s).run(stage).collapse->time, 0.46, 0.011);
    stage.stop->reference_block = 0;
    EXPECT_NEAR(Fall(s).run(stage).collapse->time, 0.33, 0.011);
}

TEST(StopLimit, EndsAStaticStage) {
    dda::Stage stage = falling(0.5);
    stage.kind = dda::StageKind::static_equilibrium;
    const dda::RunOutcome outcome = Fall(falling_blocks()).run(stage);
    EXPECT_EQ(outcome.status, RunStatus::collapsed);
    EXPECT_THAT(outcome.message, HasSubstr("block "));
}

// A run stopped by its observer at the very step that passes the limit ends as one that was not stopped.
TEST(StopLimit, IsFoundAgainByAResumedRun) {
    Fall whole(falling_blocks());
    const dda::RunOutcome expected = whole.run(falling(1));
    Fall parts(falling_blocks());
    parts.stop_after = static_cast<int>(whole.state.step_count);
    ASSERT_EQ(parts.run(falling(1)).status, RunStatus::stopped);
    parts.stop_after = 1000000;
    const dda::RunOutcome resumed = parts.run(falling(1), {.resumed = true});
    EXPECT_EQ(resumed.status, RunStatus::collapsed);
    EXPECT_EQ(resumed.message, expected.message);
    EXPECT_EQ(parts.state.step_count, whole.state.step_count);
}

}  // namespace
}  // namespace rockslope::stop_limit_test
