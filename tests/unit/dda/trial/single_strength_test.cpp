// The strength of a contact on a joint of its own: a block of 1 m on a floor, whose contacts are 0.5 m long.

#include "dda/trial/single_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/resting_block.hpp"

namespace rockslope::single_strength_test {
namespace {

using namespace scene;

const double tan30 = std::tan(radians(30));
constexpr double cohesion = 2e4, tensile_strength = 1e4;  // Pa
constexpr double length = 0.5;                            // m

struct Strengths : testing::Test {
    RestingContacts block{dda::MohrCoulomb{radians(30), cohesion, tensile_strength, radians(20), 0}};

    dda::Strength under(double normal) const { return dda::single_strength(block.problem, 0, {normal, 0}); }
};

// Mohr and Coulomb: N tan(phi) + c l.
TEST_F(Strengths, AreThoseOfTheLaw) {
    const dda::Strength strength = under(1e4);
    EXPECT_DOUBLE_EQ(strength.forward, 1e4 * tan30 + cohesion * length);
    EXPECT_DOUBLE_EQ(strength.backward, strength.forward);
    EXPECT_DOUBLE_EQ(strength.tensile, tensile_strength * length);
}

TEST_F(Strengths, AreDividedByTheReduction) {
    block.step.model.strength_reduction = 1.25;
    EXPECT_DOUBLE_EQ(under(1e4).forward, (1e4 * tan30 + cohesion * length) / 1.25);
    EXPECT_DOUBLE_EQ(under(1e4).tensile, tensile_strength * length / 1.25);
}

// A bond that yields at a quarter of its strength, Eq. (97), has a quarter of its cohesion and of its tensile
// strength; friction is whole.
TEST_F(Strengths, HaveTheShareOfTheBondThatIsHeld) {
    const std::vector<double> held_shares(2, 0.25);
    block.problem.held_shares = held_shares;
    EXPECT_NEAR(under(1e4).forward, 1e4 * tan30 + cohesion * length / 4, 1e-9);
    EXPECT_DOUBLE_EQ(under(1e4).tensile, tensile_strength * length / 4);
}

}  // namespace
}  // namespace rockslope::single_strength_test
