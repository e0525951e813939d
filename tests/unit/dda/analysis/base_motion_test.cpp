#include "dda/analysis/base_motion.hpp"

#include <gtest/gtest.h>

#include "support/case_name.hpp"
#include "support/scene.hpp"

namespace rockslope::base_motion_test {
namespace {

using namespace scene;
using dda::Motion;
using dda::TimeTable;

/// Uneven samples, so that the steps fall between them.
TimeTable record() {
    std::vector<double> times;
    std::vector<double> values;
    for (int k = 0; k <= 40; ++k) {
        times.push_back(.0137 * k);
        values.push_back(3 * std::sin(1.3 * k));
    }
    return {times, values};
}

dda::Stage shaken(const std::string& block, double duration, double step) {
    dda::Stage stage;
    stage.name = "shake";
    stage.duration = duration;
    stage.control.step = step;
    stage.base_motions.push_back({block, record(), TimeTable({0, 1}, {0, 2})});
    return stage;
}

Vec2 acceleration_at(double time) {
    return {time <= .0137 * 40 ? record().at(time) : 0, time <= 1 ? 2 * time : 0};
}

/// Observes a prescribed block and integrates the record independently in steps of `h`.
struct Follower {
    double h;
    void operator()(const dda::State& state, const dda::StepReport& report) {
        const Vec2 a = acceleration_at(state.stage_time);
        worst_acceleration =
            std::max(worst_acceleration, (state.blocks.acceleration[0].head<2>() - a).norm());
        cuts += report.cuts;
        if (std::abs(state.stage_time - (instants + 1) * h) > 1e-9 * h) {
            EXPECT_LT(state.stage_time, (instants + 1) * h) << "no step passes an instant";
            return;
        }
        ++instants;
        place += h * speed + h * h / 2 * a;
        speed += h * a;
        worst_place = std::max(worst_place, (state.blocks.centroid(0) - start - place).norm());
        worst_speed = std::max(worst_speed, (state.blocks.velocity[0].head<2>() - speed).norm());
    }
    Vec2 start = {.5, .5};
    Vec2 place = Vec2::Zero();
    Vec2 speed = Vec2::Zero();
    int instants = 0;
    double worst_acceleration = 0;
    double worst_place = 0;
    double worst_speed = 0;
    int cuts = 0;
};

// A falling block beside the base becomes too fast for the step, so steps are cut. The motion of the base at
// multiples of the stage's step must not depend on cuts.
class PrescribedBlock : public testing::TestWithParam<double> {};

TEST_P(PrescribedBlock, AcceleratesAsTheRecordAndDoesNotDrift) {
    Scene s;
    s.box({0, 0}, 1, 1, Motion::prescribed, 0, "base");
    s.box({20, 0}, 1, 1);
    s.box({20, -90}, 1, 1, Motion::fixed);
    Simulation sim(s);
    Follower follower{.01};
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) { follower(state, report); };
    dda::Stage stage = shaken("base", .8, .01);
    stage.control.displacement_ratio = GetParam();
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    if (GetParam() < 1e-3) {
        EXPECT_GT(follower.cuts, 0) << "this case must have cut steps";
    }
    EXPECT_EQ(follower.instants, 80);
    EXPECT_LT(follower.worst_acceleration, 1e-8) << "m/s2, of 3: rounding of the instants";
    EXPECT_LT(follower.worst_place, 1e-12) << "m, rounding of some hundred steps";
    EXPECT_LT(follower.worst_speed, 1e-12) << "m/s, rounding of some hundred steps";
}
INSTANTIATE_TEST_SUITE_P(DisplacementRatios, PrescribedBlock, testing::Values(.01, 5e-4),
                         [](const auto& tested) { return case_name(case_number(tested.param)); });

TEST(BaseMotion, MovesThePrescribedBlockOfItsNameOrAllIfUnnamed) {
    Scene s;
    s.box({0, 0}, 1, 1, Motion::prescribed, 0, "base");
    s.box({2, 0}, 1, 1, Motion::prescribed, 0, "wall");
    s.box({4, 0}, 1, 1, Motion::fixed);
    s.box({6, 0}, 1, 1);
    const dda::BlockSystem blocks = dda::initial_block_system(s.model);
    const auto all = dda::prescribe_motion(s.model, shaken("", 1, .01), blocks, .01, .01);
    const auto one = dda::prescribe_motion(s.model, shaken("wall", 1, .01), blocks, .01, .01);
    EXPECT_DOUBLE_EQ(all.acceleration[0][0], record().at(.01));
    EXPECT_DOUBLE_EQ(all.acceleration[1][0], record().at(.01));
    EXPECT_DOUBLE_EQ(all.displacement[0][0], record().at(.01) * .5e-4);
    EXPECT_TRUE(all.acceleration[2].isZero(0));
    EXPECT_TRUE(all.acceleration[3].isZero(0));
    EXPECT_TRUE(one.acceleration[0].isZero(0));
    EXPECT_DOUBLE_EQ(one.acceleration[1][1], .02);
}

TEST(BaseMotion, IsZeroOutsideTheRecordAndInStaticStages) {
    Scene s;
    s.box({0, 0}, 1, 1, Motion::prescribed, 0, "base");
    dda::BlockSystem blocks = dda::initial_block_system(s.model);
    blocks.velocity[0][0] = 3;
    dda::Stage stage = shaken("base", 1, .01);
    for (const double time : {-.1, 1.12}) {
        const auto motion = dda::prescribe_motion(s.model, stage, blocks, .01, time);
        EXPECT_TRUE(motion.acceleration[0].isZero(0)) << time;
        EXPECT_DOUBLE_EQ(motion.displacement[0][0], .03) << "constant velocity";
    }
    const auto cut = dda::prescribe_motion(s.model, stage, blocks, .002, .013);
    EXPECT_NEAR(cut.acceleration[0][1], .026, 1e-15) << "value of the record at the end of the step";
    EXPECT_NEAR(cut.velocity_change[0][1], .002 * .04, 1e-15)
        << "value of the record at 0.02 s, the next multiple of the step";
    stage.kind = dda::StageKind::static_equilibrium;
    EXPECT_TRUE(dda::prescribe_motion(s.model, stage, blocks, .01, .5).displacement[0].isZero(0));
}

}  // namespace
}  // namespace rockslope::base_motion_test
