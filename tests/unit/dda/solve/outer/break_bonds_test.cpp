#include "dda/solve/outer/break_bonds.hpp"

#include <gtest/gtest.h>

#include "support/resting_block.hpp"

namespace rockslope::break_bonds_test {
namespace {

using namespace scene;
using dda::ContactState;

// A bond bears 5e4 Pa over 0.5 m: 25 kN of tension.
TEST(BreakBonds, BreaksThemBeyondTheTensileStrength) {
    RestingContacts block(dda::MohrCoulomb{radians(30), 1e5, 5e4, radians(30), 0});
    ASSERT_TRUE(block.trials.is_bonded(0));
    block.move(0, -2.4e-5);
    block.bounds.update();
    EXPECT_FALSE(dda::break_bonds(block.problem, block.trials));
    EXPECT_NEAR(block.evaluated()[0].normal_force, -2.4e4, 1e-5);
    EXPECT_EQ(block.evaluated()[0].state, ContactState::locked);
    block.move(0, -2.6e-5);
    block.bounds.update();
    EXPECT_TRUE(dda::break_bonds(block.problem, block.trials));
    block.bounds.update();
    EXPECT_TRUE(block.evaluated()[0].bond_broken);
    EXPECT_EQ(block.evaluated()[0].normal_force, 0);
    EXPECT_EQ(block.evaluated()[0].state, ContactState::open);
    EXPECT_FALSE(dda::break_bonds(block.problem, block.trials)) << "broken already";
}

}  // namespace
}  // namespace rockslope::break_bonds_test
