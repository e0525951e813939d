#include "dda/analysis/lost_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scene.hpp"

namespace rockslope::lost_blocks_test {
namespace {

using namespace scene;

/// A block rests on the ground, another one beside it has none under it and falls from 0.5 m above the
/// ground's lowest corner.
Scene block_beside_the_ground() {
    Scene s;
    s.box({0, -1}, 2, 1, dda::Motion::fixed);
    s.box({0.5, 0}, 1, 1);
    s.box({5, -0.5}, 1, 1);
    return s;
}

// It is below the ground when its upper corners have fallen by 1.5 m.
constexpr double fall = 1.5;
const double time_of_fall = std::sqrt(2 * fall / g);

TEST(LostBlocks, AreNotedOnceWhenTheyAreBelowAllGround) {
    Simulation sim(block_beside_the_ground());
    ASSERT_EQ(sim.shake(1.2, 5e-3).status, dda::RunStatus::completed);
    ASSERT_EQ(sim.state.lost_blocks.size(), 1);
    EXPECT_EQ(sim.state.lost_blocks[0].block, dda::BlockIndex(2));
    EXPECT_NEAR(sim.state.lost_blocks[0].time, time_of_fall, 0.01) << "two steps";
    EXPECT_TRUE(sim.state.is_present(dda::BlockIndex(2)));
    EXPECT_NEAR(sim.moved(2).y(), -g * 1.2 * 1.2 / 2, 0.05) << "it falls on";
    EXPECT_TRUE(dda::note_lost_blocks(sim.model, sim.state).empty());
}

TEST(LostBlocks, AreRemovedWhereTheModelSaysSo) {
    Scene s = block_beside_the_ground();
    s.model.removes_lost_blocks = true;
    Simulation sim(s);
    ASSERT_EQ(sim.shake(1.2, 5e-3).status, dda::RunStatus::completed);
    EXPECT_FALSE(sim.state.is_present(dda::BlockIndex(2)));
    EXPECT_NEAR(sim.moved(2).y(), -fall, 0.05) << "where it was";
    EXPECT_NEAR(sim.state.stage_time, 1.2, 1e-9);
    EXPECT_TRUE(sim.state.is_present(dda::BlockIndex(1)));
    EXPECT_NEAR(sim.moved(1).norm(), 0, 1e-5);
    EXPECT_NEAR(sim.state.energy.residual(), 0, 1e-6 * 2500 * g * fall);
}

TEST(LostBlocks, NeedAGround) {
    Scene s;
    s.box({0, 0}, 1, 1);
    Simulation sim(s);
    ASSERT_EQ(sim.shake(1.0, 5e-3).status, dda::RunStatus::completed);
    EXPECT_TRUE(sim.state.lost_blocks.empty());
}

}  // namespace
}  // namespace rockslope::lost_blocks_test
