#include "dda/terms/contact_damping.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace rockslope::contact_damping_test {
namespace {

using namespace scene;

/// Blocks of 2500, 5000 and 10 000 kg on a fixed base; springs of 5e7 N/m: omega is 100 rad/s for the middle
/// one.
Scene three_blocks(double damping) {
    Scene s;
    s.model.normal_penalty = 5e7;
    s.model.joint_materials[0].contact_damping = damping;
    s.box({-10, -1}, 30, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    s.box({2, 0}, 2, 1);
    s.box({5, 0}, 4, 1);
    return s;
}

dda::Stage stage_of(dda::StageKind kind, double step) {
    dda::Stage stage;
    stage.kind = kind;
    stage.control.step = step;
    return stage;
}

// The integration (1/2, 1) has the damping ratio omega dt / 4.
TEST(IneffectiveDamping, IsToldFromFourTimesTheRatioOn) {
    const dda::Model model = three_blocks(.2).model;
    const std::vector<dda::Stage> stages = {stage_of(dda::StageKind::static_equilibrium, 1),
                                            stage_of(dda::StageKind::dynamic, .0079),
                                            stage_of(dda::StageKind::dynamic, .0081)};
    const auto found = dda::ineffective_damping(model, stages);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->stage, 2U);
    EXPECT_EQ(found->joint_material, 0);
    EXPECT_NEAR(found->frequency_step, .81, 1e-12);
}

TEST(IneffectiveDamping, IsNotToldWithoutDampingOrWithAnUndampedIntegration) {
    std::vector<dda::Stage> stages = {stage_of(dda::StageKind::dynamic, 1)};
    EXPECT_FALSE(dda::ineffective_damping(three_blocks(0).model, stages));
    EXPECT_TRUE(dda::ineffective_damping(three_blocks(.2).model, stages));
    stages[0].newmark_beta = .25;
    stages[0].newmark_gamma = .5;
    EXPECT_FALSE(dda::ineffective_damping(three_blocks(.2).model, stages));
}

}  // namespace
}  // namespace rockslope::contact_damping_test
