// The shear bounds of a block on a floor at a displacement.

#include <gtest/gtest.h>

#include <cmath>

#include "support/resting_block.hpp"

namespace rockslope::trial_bounds_test {
namespace {

using namespace scene;
using dda::ContactState;

const double tan30 = std::tan(radians(30));

TEST(TrialBounds, SlideAtTheBoundOfTheirLaw) {
    for (const double direction : {1.0, -1.0}) {
        RestingContacts block(Scene::mohr_coulomb(30));
        block.move(direction * 2e-5, 1e-5);
        block.trials.update_bounds();
        for (const dda::EvaluatedContact& contact : block.evaluated()) {
            EXPECT_EQ(contact.state, ContactState::sliding);
            EXPECT_NEAR(contact.shear_force, direction * 1e4 * tan30, 1e-5);
            EXPECT_NEAR(contact.slip, direction * (2e-5 - 1e4 * tan30 / block.spring), 1e-14);
        }
    }
}

TEST(TrialBounds, HaveReducedStrengths) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.strength_reduction = 1.25;
    RestingContacts block(s);
    block.move(2e-5, 1e-5);
    block.trials.update_bounds();
    EXPECT_NEAR(block.evaluated()[0].shear_force, 1e4 * tan30 / 1.25, 1e-5);
}

// Eq. (75): cohesion, here 2e4 Pa over 0.5 m, acts in a step at whose start the contact was closed.
TEST(TrialBounds, HaveCohesionOnlyIfTheyWereClosed) {
    for (const bool was_closed : {true, false}) {
        RestingContacts block(dda::MohrCoulomb{radians(30), 2e4, 0, radians(30), 2e4});
        for (dda::Contact& contact : block.step.found.set.contacts)
            contact.state = was_closed ? ContactState::locked : ContactState::open;
        dda::TrialContacts trials(block.problem, block.step.pool);
        const std::vector<Vec6> d{RestingContacts::displacement(1e-4, 1e-5)};
        trials.set_displacement(d, d);
        trials.update_bounds();
        std::vector<dda::EvaluatedContact> evaluated(2);
        trials.evaluate(evaluated);
        EXPECT_NEAR(evaluated[0].shear_force, 1e4 * tan30 + (was_closed ? 1e4 : 0), 1e-5) << was_closed;
    }
}

// A line that is not entered first bears nothing, its cohesion included.
TEST(TrialBounds, HaveNoCohesionWhereTheyMayNotClose) {
    RestingContacts block(dda::MohrCoulomb{radians(30), 2e4, 0, radians(30), 2e4});
    block.step.found.set.contacts[0].inhibited = true;
    for (dda::Contact& contact : block.step.found.set.contacts) contact.state = ContactState::sliding;
    const dda::TrialContacts trials(block.problem, block.step.pool);
    EXPECT_FALSE(trials.may_close(0));
    EXPECT_FALSE(trials.coheres(0));
    EXPECT_TRUE(trials.coheres(1));
}

// A bond bears 5e4 Pa over 0.5 m: 25 kN of tension.
TEST(TrialBounds, BreakBondsBeyondTheTensileStrength) {
    RestingContacts block(dda::MohrCoulomb{radians(30), 1e5, 5e4, radians(30), 0});
    ASSERT_TRUE(block.trials.is_bonded(0));
    block.move(0, -2.4e-5);
    block.trials.update_bounds();
    EXPECT_FALSE(block.trials.break_bonds());
    EXPECT_NEAR(block.evaluated()[0].normal_force, -2.4e4, 1e-5);
    EXPECT_EQ(block.evaluated()[0].state, ContactState::locked);
    block.move(0, -2.6e-5);
    block.trials.update_bounds();
    EXPECT_TRUE(block.trials.break_bonds());
    block.trials.update_bounds();
    EXPECT_TRUE(block.evaluated()[0].bond_broken);
    EXPECT_EQ(block.evaluated()[0].normal_force, 0);
    EXPECT_EQ(block.evaluated()[0].state, ContactState::open);
    EXPECT_FALSE(block.trials.break_bonds()) << "broken already";
}

TEST(TrialBounds, BoundsCanBeReadAndSet) {
    RestingContacts block(Scene::mohr_coulomb(30));
    block.move(2e-5, 1e-5);
    block.trials.update_bounds();
    Eigen::VectorXd bounds = block.trials.shear_bounds();
    ASSERT_EQ(bounds.size(), 4);
    for (const double bound : bounds) EXPECT_NEAR(bound, 1e4 * tan30, 1e-5);
    bounds << 100, 200, -300, 400;
    block.trials.set_shear_bounds(bounds);
    EXPECT_EQ(block.trials.shear_bounds()[2], 0) << "negative bounds are none";
    EXPECT_EQ(block.evaluated()[0].shear_force, 100);
    EXPECT_EQ(block.evaluated()[1].shear_force, 0);
    block.move(-2e-5, 1e-5);
    EXPECT_EQ(block.evaluated()[0].shear_force, -200);
    EXPECT_EQ(block.evaluated()[1].shear_force, -400);
}

}  // namespace
}  // namespace rockslope::trial_bounds_test
