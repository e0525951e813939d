// A block on a spring whose period is known, against the damping of the integration in closed form.

#include "dda/monitor/spring_resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/scene.hpp"

namespace rockslope::spring_resolution_test {
namespace {

using namespace scene;

/// A block of 1 m by 1 m, 2500 kg, on a floor; its joint's springs are 1e6 Pa/m in shear, 1e8 Pa/m normal.
Scene block_on_soft_joint() {
    Scene s;
    s.model.joint_materials[0].shear_stiffness = 1e6;
    s.model.joint_materials[0].normal_stiffness = 1e8;
    s.box({0, -1}, 1, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    return s;
}

dda::Stage stage_of(double step) {
    dda::Stage stage;
    stage.duration = 1;
    stage.control.step = step;
    return stage;
}

TEST(SpringResolution, CountsTheStepsOfAPeriod) {
    const Scene s = block_on_soft_joint();
    const std::vector<dda::Stage> stages{stage_of(4e-3)};
    const auto resolutions = dda::spring_resolutions(s.model, stages);
    ASSERT_EQ(resolutions.size(), 1u);
    EXPECT_NEAR(resolutions[0].shear_period_steps, 2 * std::numbers::pi / std::sqrt(1e6 / 2500) / 4e-3, 1e-9);
    EXPECT_NEAR(resolutions[0].normal_period_steps, 2 * std::numbers::pi / std::sqrt(1e8 / 2500) / 4e-3,
                1e-9);
    EXPECT_NEAR(resolutions[0].swing, 2500 * g / 1e6, 1e-12);
    EXPECT_TRUE(dda::loses_swing(resolutions[0]));
    const double step = dda::step_that_keeps_swing(resolutions[0], stages[0]);
    const auto kept = dda::spring_resolutions(s.model, std::vector{stage_of(step)});
    EXPECT_NEAR(kept[0].lost_per_period, dda::largest_lost_per_period, 1e-12);
}

// The engine itself: a block that swings on its joint loses what is predicted, here 22 % in a period. Its own
// shear strain and the second order in the step are below 1 % of the amplitude.
TEST(SpringResolution, PredictsWhatASwingLoses) {
    Scene s = block_on_soft_joint();
    s.model.joint_materials[0] = elastic_joint(1e8, 1e6);
    Simulation run(s);
    ASSERT_EQ(run.settle(4e-3).status, dda::RunStatus::completed);
    run.velocity(1)[0] = 0.02;  // 1 mm at 20 rad/s
    const double period = 2 * std::numbers::pi / 20;
    std::vector<double> peaks;
    double before = 0, last = 0;
    run.on_step = [&](const dda::State& state, const dda::StepReport&) {
        const double now = state.blocks.centroid(1).x() - 0.5;
        if (last > before && last >= now) peaks.push_back(last);
        before = last;
        last = now;
    };
    ASSERT_EQ(run.shake(2.5 * period, 4e-3).status, dda::RunStatus::completed);
    ASSERT_GE(peaks.size(), 2u);
    const auto resolution = dda::spring_resolutions(s.model, std::vector{stage_of(4e-3)})[0];
    EXPECT_NEAR(1 - peaks[1] / peaks[0], resolution.lost_per_period, 0.01);
}

// Springs that stand for rigid contact swing by micrometres: no step resolves them, and nothing is lost.
TEST(SpringResolution, IsNotMissedWhereASwingIsSmall) {
    Scene s = block_on_soft_joint();
    s.model.joint_materials[0].shear_stiffness = 5e10;
    EXPECT_FALSE(dda::loses_swing(dda::spring_resolutions(s.model, std::vector{stage_of(4e-3)})[0]));
    dda::Stage undamped = stage_of(4e-3);
    undamped.newmark_beta = 0.25;
    undamped.newmark_gamma = 0.5;
    const auto resolution = dda::spring_resolutions(block_on_soft_joint().model, std::vector{undamped})[0];
    EXPECT_EQ(resolution.lost_per_period, 0);
    EXPECT_FALSE(dda::loses_swing(resolution));
}

TEST(SpringResolution, IsOfDynamicStagesWithFreeBlocks) {
    dda::Stage settle;
    settle.kind = dda::StageKind::static_equilibrium;
    EXPECT_TRUE(dda::spring_resolutions(block_on_soft_joint().model, std::vector{settle}).empty());
    Scene fixed;
    fixed.box({0, 0}, 1, 1, dda::Motion::fixed);
    EXPECT_TRUE(dda::spring_resolutions(fixed.model, std::vector{stage_of(1e-3)}).empty());
}

}  // namespace
}  // namespace rockslope::spring_resolution_test
