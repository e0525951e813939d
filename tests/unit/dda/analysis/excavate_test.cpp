#include <gtest/gtest.h>

#include "dda/analysis/excavate.hpp"
#include "support/column.hpp"

namespace rockslope::excavate_test {
namespace {

using namespace scene;

constexpr double weight = 2500 * g;  // N, of a box of 1 m x 1 m

TEST(Excavation, StressBelowFallsToTheNewOverburden) {
    Scene s = column(4);
    s.model.excavations = {{"crest", 2, {4}}, {"next", 3, {3}}};
    Simulation sim(s);
    for (const int left : {4, 3, 2}) {
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        // The stress of a constant-strain block carries half its own weight and the weight of all blocks
        // above. The tolerance is that of the column in the verification catalogue.
        for (int k = 1; k <= left; ++k)
            EXPECT_NEAR(sim.stress(k)[1], -weight * (left - k + 0.5), 0.01 * weight * (left - k + 0.5));
        for (const dda::Contact& c : sim.state.contacts.contacts)
            EXPECT_TRUE(c.corner_block <= left && c.edge_block <= left);
        // Removed blocks have no stress.
        for (int k = left + 1; k <= 4; ++k) EXPECT_EQ(sim.stress(k), dda::Vec3::Zero());
    }
}

TEST(Excavation, BlockWithoutItsSupportFallsFreely) {
    Scene s = column(2);
    s.model.excavations = {{"support", 2, {1}}};
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    ASSERT_EQ(sim.shake(0.3, 0.001).status, dda::RunStatus::completed);
    // Constant acceleration is integrated exactly; 1e-9 m covers the remaining motion of the settled state
    // and rounding.
    EXPECT_NEAR(sim.moved(2).y(), -g * 0.3 * 0.3 / 2, 1e-9);
    EXPECT_NEAR(sim.velocity(2)[1], -g * 0.3, 1e-8);
    EXPECT_EQ(sim.moved(1), Vec2::Zero());
}

TEST(Excavation, EnergyBalanceAccountsForRemovedBlocks) {
    Scene s = column(3);
    s.model.excavations = {{"crest", 2, {3}}};
    Simulation sim(s);
    sim.settle();
    const double before = sim.state.energy.residual();
    const double stores = sim.state.energy.stores();
    ASSERT_TRUE(dda::excavate(sim.model, 2, sim.state));
    EXPECT_NEAR(sim.state.energy.residual(), before, 1e-12 * std::abs(stores));
    EXPECT_NE(sim.state.energy.excavated, 0);
    EXPECT_FALSE(dda::excavate(sim.model, 2, sim.state)) << "the block is already removed";
}

TEST(Excavation, RemovesBoltsAndFixedPointsOfRemovedBlocks) {
    Scene s = column(3);
    const int first = s.material_point(1, {0.5, 0.5}), second = s.material_point(2, {0.5, 1.5}),
              third = s.material_point(3, {0.5, 2.5});
    s.model.bolts = {{"gone", second, third, 1e6, 1e3, 0}, {"kept", first, second, 1e6, 2e3, 0}};
    s.model.fixed_points = {{third, true, false}, {first, true, false}};
    s.model.excavations = {{"crest", 1, {3}}};
    dda::State state = dda::initial_state(s.model);
    ASSERT_TRUE(dda::excavate(s.model, 1, state));
    EXPECT_EQ(state.bolt_force, std::vector<double>{2e3});
    const dda::Model active_model = dda::without_removed_blocks(s.model, state.removed);
    ASSERT_EQ(active_model.bolts.size(), 1U);
    EXPECT_EQ(active_model.bolts[0].name, "kept");
    ASSERT_EQ(active_model.fixed_points.size(), 1U);
    EXPECT_EQ(active_model.fixed_points[0].point, first);
    EXPECT_EQ(active_model.motion[3], dda::Motion::removed);
}

}  // namespace
}  // namespace rockslope::excavate_test
