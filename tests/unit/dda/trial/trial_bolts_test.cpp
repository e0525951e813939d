// A bolt between a block and the floor that it rests on.

#include "dda/trial/trial_bolts.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "support/resting_block.hpp"

namespace rockslope::trial_bolts_test {
namespace {

using namespace scene;

TEST(TrialBolts, YieldAtTheirYieldForce) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    const int anchor = s.material_point(0, {0.5, -0.5}), head = s.material_point(1, {0.5, 0.5});
    s.model.bolts.push_back({"bolt", anchor, head, 1e7, 1e3, 3e3});
    RestingContacts block(s);
    dda::TrialBolts& bolts = block.trials.bolts();
    for (const auto& [raised, force, elastic, changes] :
         {std::tuple{1e-4, 2e3, true, false}, {5e-4, 3e3, false, true}, {-9e-4, -3e3, false, true}}) {
        block.move(0, -raised);
        EXPECT_NEAR(bolts.force(0), force, 1e-6);
        EXPECT_EQ(bolts.update_active_set(), changes);
        EXPECT_EQ(bolts.is_elastic(0), elastic) << raised;
    }
    EXPECT_NEAR(bolts.linear_force(0, 1), -3e3, 1e-9) << "a yielding bolt is a load";
}

}  // namespace
}  // namespace rockslope::trial_bolts_test
