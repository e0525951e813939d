#include "dda/analysis/moving_block.hpp"

#include <gtest/gtest.h>

#include "dda/analysis/run_stage.hpp"
#include "support/scene.hpp"

namespace rockslope::moving_block_test {
namespace {

using namespace scene;

/// A fixed block and three free ones, at the start of a stage.
struct FourBlocks {
    Scene s;
    dda::State state;
    FourBlocks() {
        s.model.joint_materials[0].name = "bedding";
        s.model.origin = {1000, 2000};
        s.box({0, 0}, 1, 1, dda::Motion::fixed);
        for (const double x : {10.0, 20.0, 30.0}) s.box({x, 0}, 1, 1);
        state = dda::initial_state(s.model);
        dda::begin_stage(state);
    }
    /// Moves a block that goes on to move.
    void move(int block, const Vec2& by) {
        state.blocks.moments[block].centroid += by;
        accelerate(block, -0.01 * g);
    }
    void accelerate(int block, double by) { state.blocks.acceleration[block][1] = by; }
    void add_contact(int corner_block, int edge_block, dda::ContactState contact_state, double slip) {
        dda::Contact& contact = state.contacts.contacts.emplace_back();
        contact.corner_block = corner_block;
        contact.edge_block = edge_block;
        contact.joint_material = 0;
        contact.state = contact_state;
        contact.slip = slip;
    }
};

TEST(MovingBlock, IsTheFreeBlockThatMovedFarthest) {
    FourBlocks blocks;
    blocks.move(0, {9, 9});  // fixed
    blocks.move(1, {0.3, 0.4});
    blocks.move(2, {0, -0.2});
    blocks.accelerate(1, -0.25 * g);
    EXPECT_FALSE(dda::block_moved_beyond(blocks.s.model, blocks.state, 0.51, 0, 1e-6));
    const auto moving = dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6);
    ASSERT_TRUE(moving);
    EXPECT_EQ(moving->block, 1);
    EXPECT_DOUBLE_EQ(moving->displacement, 0.5);
    EXPECT_DOUBLE_EQ(moving->unbalanced, 0.25);
    EXPECT_FALSE(moving->on);
    EXPECT_FALSE(moving->falls_freely);
}

TEST(MovingBlock, IsNotOneThatHasBeenExcavated) {
    FourBlocks blocks;
    blocks.move(1, {3, 0});
    blocks.move(2, {1, 0});
    blocks.state.removed = {0, 1, 0, 0};
    EXPECT_EQ(dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6)->block, 2);
}

// A chip that had fallen to the toe and lay there was told as one that does not stop, in place of the blocks
// that slid.
TEST(MovingBlock, IsOneThatHasComeToRestOnlyWhereNoneGoesOn) {
    FourBlocks blocks;
    blocks.move(1, {3, 0});
    blocks.move(2, {1, 0});
    blocks.accelerate(1, 0.9e-6 * g);
    EXPECT_EQ(dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0.6, 1e-6)->block, 2);
    const auto still = dda::block_moved_beyond(blocks.s.model, blocks.state, 2, 0, 1e-6);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->block, 1);
    EXPECT_EQ(dda::describe(blocks.s.model, blocks.state, *still, 1e-6),
              "block 1 at (1013.5, 2000.5) has moved 3 m out of contact, under its loads and lies still; its "
              "unbalanced force is 9e-07 of the weight");
}

// A chip of 0.05 m2 that had rolled 22 m was told in place of the 300 m2 that slid by 2 m.
TEST(MovingBlock, IsTheHeaviestBeyondTheLimit) {
    FourBlocks blocks;
    blocks.move(1, {3, 0});
    blocks.move(2, {1, 0});
    blocks.state.blocks.mass[1] *= 0.01;
    EXPECT_EQ(dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6)->block, 2);
    EXPECT_EQ(dda::block_moved_beyond(blocks.s.model, blocks.state, 2, 0, 1e-6)->block, 1);
}

TEST(MovingBlock, IsTheLeastBalancedOne) {
    FourBlocks blocks;
    EXPECT_FALSE(dda::least_balanced_block(blocks.s.model, blocks.state)) << "all are in balance";
    blocks.accelerate(0, 100);
    blocks.accelerate(2, -1);
    blocks.accelerate(3, 2);
    const auto moving = dda::least_balanced_block(blocks.s.model, blocks.state);
    ASSERT_TRUE(moving);
    EXPECT_EQ(moving->block, 3);
    EXPECT_DOUBLE_EQ(moving->unbalanced, 2 / g);
}

TEST(MovingBlock, MovesAlongItsSlidingContactWithTheLargestSlip) {
    FourBlocks blocks;
    blocks.move(1, {1, 0});
    blocks.add_contact(1, 0, dda::ContactState::sliding, 0.1);
    blocks.add_contact(0, 1, dda::ContactState::sliding, -0.3);
    blocks.add_contact(1, 2, dda::ContactState::locked, 0.7);
    blocks.add_contact(2, 3, dda::ContactState::sliding, 0.9);
    const auto moving = dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6);
    ASSERT_TRUE(moving->on);
    EXPECT_EQ(moving->on->slip, -0.3);
}

TEST(MovingBlock, IsDescribedInTheUsersCoordinates) {
    FourBlocks blocks;
    blocks.move(1, {0.25, -0.5});
    blocks.accelerate(1, -g);
    const auto fall = dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6);
    EXPECT_EQ(dda::describe(blocks.s.model, blocks.state, *fall, 1e-6),
              "block 1 at (1010.75, 2000) has moved 0.559 m in free fall and does not stop; its unbalanced "
              "force is 1 of the weight");
    blocks.add_contact(1, 0, dda::ContactState::sliding, 0.1);
    const auto slide = dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6);
    EXPECT_NE(dda::describe(blocks.s.model, blocks.state, *slide, 1e-6).find(" m along 'bedding' and does"),
              std::string::npos);
}

// "In free fall" is said of what falls freely, not of a block that water or a load pushes out, or that is
// held.
TEST(MovingBlock, FallsFreelyOnlyAtTheAccelerationOfGravity) {
    FourBlocks blocks;
    blocks.move(1, {1, 0});
    blocks.accelerate(1, 0.5 * g);
    const auto manner = [&] {
        return dda::describe(blocks.s.model, blocks.state,
                             *dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0, 1e-6), 1e-6);
    };
    EXPECT_NE(manner().find(" m out of contact, under its loads and"), std::string::npos) << manner();
    blocks.add_contact(0, 1, dda::ContactState::locked, 0);
    EXPECT_NE(manner().find(" m in contact with block 0 without sliding on it and"), std::string::npos);
}

// Water along a face gives 1.5 g to the side, and the block is told as pushed where that is at least half of
// its acceleration.
TEST(MovingBlock, NamesTheLoadThatPushesIt) {
    FourBlocks blocks;
    const double mass = blocks.state.blocks.mass[1];
    const dda::EdgeIndex left_face = 7;
    blocks.s.model.loads.push_back(dda::JointWater{{left_face}, 1.5 * g * mass, {}});
    blocks.move(1, {1, 0});
    const auto manner = [&](double to_the_side, double down) {
        blocks.state.blocks.acceleration[1].head<2>() = Vec2(to_the_side, -down);
        return dda::describe_manner(blocks.s.model, dda::moving_block(blocks.s.model, blocks.state, 1));
    };
    EXPECT_EQ(manner(1.5 * g, g), "out of contact, pushed by joint_water");
    EXPECT_EQ(manner(0, 0.5 * g), "out of contact, under its loads");
    EXPECT_EQ(manner(0, 0), "out of contact, under its loads") << "at rest";
    EXPECT_EQ(manner(0, g), "in free fall");
    EXPECT_EQ(manner(3.1 * g, 0), "out of contact, under its loads") << "less than half of its acceleration";
    blocks.add_contact(0, 1, dda::ContactState::locked, 0);
    EXPECT_EQ(manner(2.9 * g, 0), "in contact with block 0 without sliding on it, pushed by joint_water");
    blocks.add_contact(1, 0, dda::ContactState::sliding, 0.1);
    EXPECT_EQ(manner(2.9 * g, 0), "along 'bedding', pushed by joint_water");
}

// A measured point of a block whose motion is prescribed may end a stage, too: no load moves that block.
TEST(MovingBlock, IsNotPushedWhereItsMotionIsPrescribed) {
    FourBlocks blocks;
    const dda::EdgeIndex left_face = 3;
    blocks.s.model.loads.push_back(dda::JointWater{{left_face}, 1e6, {}});
    blocks.state.blocks.acceleration[0].head<2>() = Vec2(1, 0);
    EXPECT_EQ(dda::moving_block(blocks.s.model, blocks.state, 0).pushed_by, nullptr);
}

// Blocks 1 to 3 have one mass each: two that moved are 2/3 of it.
TEST(MovingBlock, HasNotMovedBeyondTheLimitWhereTooLittleOfTheMassHas) {
    FourBlocks blocks;
    blocks.move(1, {1, 0});
    blocks.move(2, {2, 0});
    EXPECT_FALSE(dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0.67, 1e-6));
    EXPECT_EQ(dda::block_moved_beyond(blocks.s.model, blocks.state, 0.1, 0.66, 1e-6)->block, 2);
    EXPECT_EQ(dda::block_moved_beyond(blocks.s.model, blocks.state, 1.5, 0.33, 1e-6)->block, 2)
        << "1/3 of the mass";
    EXPECT_FALSE(dda::block_moved_beyond(blocks.s.model, blocks.state, 1.5, 0.34, 1e-6));
}

TEST(MovingBlock, IsOutOfBalanceByMoreThanTheTolerance) {
    FourBlocks blocks;
    blocks.accelerate(0, 100);  // fixed
    blocks.accelerate(1, 1e-6 * g);
    blocks.accelerate(2, 2e-6 * g);
    EXPECT_EQ(dda::moving_blocks(blocks.s.model, blocks.state, 1.5e-6), std::vector<dda::BlockIndex>{2});
    dda::Stage stage;
    stage.tolerance = 1.5e-6;
    stage.moving_share = 0.33;
    EXPECT_FALSE(dda::is_at_rest(blocks.s.model, blocks.state, stage));
    stage.moving_share = 0.34;
    EXPECT_TRUE(dda::is_at_rest(blocks.s.model, blocks.state, stage)) << "a third moves";
    blocks.accelerate(2, std::nan(""));
    stage.moving_share = 0;
    EXPECT_FALSE(dda::is_at_rest(blocks.s.model, blocks.state, stage)) << "not a number is no rest";
}

}  // namespace
}  // namespace rockslope::moving_block_test
