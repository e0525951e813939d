#include "dda/analysis/base_motion.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

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

/// Follows a prescribed block and integrates the record beside the engine.
struct Follower {
    void operator()(const dda::State& state, const dda::StepReport& report) {
        const bool inside = state.stage_time <= .0137 * 40;
        const Vec2 a(inside ? record().at(state.stage_time) : 0,
                     state.stage_time <= 1 ? 2 * state.stage_time : 0);
        place += report.step * speed + report.step * report.step / 2 * a;
        speed += report.step * a;
        worst_acceleration =
            std::max(worst_acceleration, (state.blocks.acceleration[0].head<2>() - a).norm());
        worst_place = std::max(worst_place, (state.blocks.centroid(0) - start - place).norm());
        cuts += report.cuts;
    }
    Vec2 start = {.5, .5};
    Vec2 place = Vec2::Zero();
    Vec2 speed = Vec2::Zero();
    double worst_acceleration = 0;
    double worst_place = 0;
    int cuts = 0;
};

// A falling block beside the base gets too fast for the step after a while, which cuts the base's steps as
// well.
class PrescribedBlock : public testing::TestWithParam<double> {};

TEST_P(PrescribedBlock, AcceleratesAsTheRecord) {
    Scene s;
    s.box({0, 0}, 1, 1, Motion::prescribed, 0, "base");
    s.box({20, 0}, 1, 1);
    s.box({20, -90}, 1, 1, Motion::fixed);
    Simulation sim(s);
    Follower follower;
    sim.each_step = [&](const dda::State& state, const dda::StepReport& report) { follower(state, report); };
    dda::Stage stage = shaken("base", .8, .01);
    stage.control.displacement_ratio = GetParam();
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    if (GetParam() < 1e-3) {
        EXPECT_GT(follower.cuts, 0) << "this case is about cut steps";
    }
    EXPECT_LT(follower.worst_acceleration, 1e-12);
    EXPECT_LT(follower.worst_place, 1e-12) << "m, rounding of some hundred steps";
}
INSTANTIATE_TEST_SUITE_P(DisplacementRatios, PrescribedBlock, testing::Values(.01, 5e-4));

TEST(BaseMotion, AnEmptyNameMovesAllPrescribedBlocksAndANameOnlyItsOwn) {
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
    for (const double time : {-.1, 1.1}) {
        const auto motion = dda::prescribe_motion(s.model, stage, blocks, .01, time);
        EXPECT_TRUE(motion.acceleration[0].isZero(0)) << time;
        EXPECT_DOUBLE_EQ(motion.displacement[0][0], .03) << "it coasts";
    }
    stage.kind = dda::StageKind::static_equilibrium;
    EXPECT_TRUE(dda::prescribe_motion(s.model, stage, blocks, .01, .5).displacement[0].isZero(0));
}

}  // namespace
