#include "dda/analysis/deepest_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scene.hpp"

namespace rockslope::deepest_contact_test {
namespace {

using namespace scene;

/// A block of 2 m x 1 m on the ground, on springs that its weight of 49 kN presses by w / (2 k).
Simulation resting(double spring) {
    Scene s;
    s.model.normal_penalty = s.model.shear_penalty = spring;
    s.box({-1, -1}, 4, 1, dda::Motion::fixed);
    s.box({0, 0}, 2, 1);
    return Simulation(s);
}
constexpr double weight = 2 * 2500 * g;

TEST(DeepestContact, IsThatOfTheLargestShareOfTheSmallerBlock) {
    Simulation sim = resting(1e7);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    const dda::DeepestContact& deepest = sim.state.deepest_contact;
    const double at_rest = weight / (2 * 1e7);
    EXPECT_GT(deepest.depth, at_rest * (1 - 1e-6));
    EXPECT_LT(deepest.depth, 2 * at_rest) << "no more than a sudden load presses";
    EXPECT_NEAR(deepest.share, deepest.depth / std::sqrt(2.0), 1e-8) << "the block is strained";
    EXPECT_EQ(deepest.corner_block, dda::BlockIndex(1));
    EXPECT_EQ(deepest.edge_block, dda::BlockIndex(0));
    EXPECT_LT(deepest.share, dda::deep_share);
}

TEST(DeepestContact, StaysAfterTheBlockHasRisen) {
    Simulation sim = resting(1e6);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    EXPECT_GT(sim.state.deepest_contact.share, dda::deep_share);
    const double depth = sim.state.deepest_contact.depth, time = sim.state.deepest_contact.time;
    sim.velocity(1)[1] = 1;
    ASSERT_EQ(sim.shake(0.1, 1e-3).status, dda::RunStatus::completed);
    EXPECT_EQ(sim.state.deepest_contact.depth, depth);
    EXPECT_EQ(sim.state.deepest_contact.time, time);
}

}  // namespace
}  // namespace rockslope::deepest_contact_test
