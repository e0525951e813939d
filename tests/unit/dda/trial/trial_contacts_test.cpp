// A block on a floor: what its two contacts bear at a displacement, and what that makes of the active set.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "support/resting_block.hpp"

namespace rockslope::trial_contacts_test {
namespace {

using namespace scene;
using dda::ContactState;

const double tan30 = std::tan(radians(30));

TEST(TrialContacts, BearTheForceOfTheirSprings) {
    RestingContacts block(Scene::mohr_coulomb(30));
    ASSERT_EQ(block.trials.count(), 2u);
    block.move(2e-6, 1e-5);
    block.bounds.update();
    for (const dda::EvaluatedContact& contact : block.evaluated()) {
        EXPECT_EQ(contact.state, ContactState::locked);
        EXPECT_NEAR(contact.gap, -1e-5, 1e-15);
        EXPECT_NEAR(contact.normal_force, 1e4, 1e-5);
        EXPECT_NEAR(contact.shear_force, 2e3, 1e-5);
        EXPECT_NEAR(contact.displacement, 2e-6, 1e-18);
        EXPECT_EQ(contact.slip, 0);
    }
}

TEST(TrialContacts, BearNothingWhereTheyAreOpen) {
    RestingContacts block(Scene::mohr_coulomb(30));
    block.move(2e-5, -1e-5);
    block.bounds.update();
    for (const dda::EvaluatedContact& contact : block.evaluated()) {
        EXPECT_EQ(contact.state, ContactState::open);
        EXPECT_EQ(contact.normal_force, 0);
        EXPECT_EQ(contact.shear_force, 0);
        EXPECT_EQ(contact.slip, 0);
    }
}

// A displacement that is no number, or so large that its forces are not, is no solution.
TEST(TrialContacts, ForceChangeOfADisplacementWithoutForcesIsInfinite) {
    for (const double no_displacement : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        RestingContacts block(Scene::mohr_coulomb(30));
        block.move(2e-6, no_displacement);
        EXPECT_EQ(block.trials.force_change().largest, std::numeric_limits<double>::infinity());
    }
}

// A contact that was open has no springs in the linear system before the first update, so all of the law's
// force is a change. With springs its forces are those of the law.
TEST(TrialContacts, ForceChangeIsTheDifferenceOfLawAndLinearSystem) {
    RestingContacts block(Scene::mohr_coulomb(30));
    for (dda::Contact& contact : block.step.found.set.contacts) contact.state = ContactState::open;
    dda::StepContacts contacts(block.problem, block.step.pool);
    dda::TrialContacts& trials = contacts.trials;
    ASSERT_FALSE(trials[0].has_normal_spring);
    const std::vector<Vec6> d{RestingContacts::displacement(2e-6, 1e-5)};
    trials.set_displacement(d, d);
    contacts.bounds.update();
    const auto before = trials.force_change();
    EXPECT_NEAR(before.largest, 1e4, 1e-5);
    EXPECT_TRUE(before.contact.exists());
    EXPECT_NEAR(trials.tolerance(), block.step.control.force_tolerance * 1e4, 1e-9);
    EXPECT_TRUE(trials.update_active_set());
    EXPECT_TRUE(trials[0].has_normal_spring);
    EXPECT_TRUE(trials[0].has_shear_spring);
    trials.set_displacement(d, d);
    EXPECT_NEAR(trials.force_change().largest, 0, 1e-9);
    EXPECT_FALSE(trials.update_active_set());
}

// A corner that slides along a glued joint meets the next edge of it as a new, open contact.
TEST(TrialContacts, ABondBearsTensionFromTheStartAlsoInANewContact) {
    RestingContacts block(dda::Elastic{});
    for (dda::Contact& contact : block.step.found.set.contacts) {
        contact.state = ContactState::open;
        contact.bonded = true;
        contact.gap = 1e-7;
    }
    const dda::TrialContacts trials(block.problem, block.step.pool);
    for (const int k : {0, 1}) {
        EXPECT_TRUE(trials[k].has_normal_spring);
        EXPECT_TRUE(trials[k].has_shear_spring);
        EXPECT_NEAR(trials.linear_forces(k, 0, 0).normal, -100, 1e-6);
    }
}

// Held tilts and bounds make a convex potential. Its Newton's method needs the spring that the law has
// between the bounds; the joint's own state, which follows its normal force, may be another.
TEST(TrialContacts, WithHeldTiltsTheShearSpringIsThatOfTheHeldBounds) {
    RestingContacts block(Scene::mohr_coulomb(30));
    dda::TrialContacts& trials = block.trials;
    block.move(0, 1e-5);
    block.bounds.update();
    const double tilt = 0.2;
    for (const int k : {0, 1}) {
        trials[k].dilating = {0.1, 0};
        trials[k].set_tilt(tilt);
    }
    // The law is the whole shear force less tilt times normal force.
    const auto shear = [&](double along) { return trials.law(0).forces(0, along).shear; };
    int locked_count = 0;
    for (const double along : {-1e-5, -7e-6, -3e-6, 0.0, 3e-6, 7e-6, 1e-5}) {
        block.move(along, 1e-5);
        trials.force_change();
        trials.update_active_set(dda::TrialContacts::Tilts::held);
        EXPECT_EQ(trials[0].tilt, tilt);
        const double stiffness = (shear(along + 1e-9) - shear(along - 1e-9)) / 2e-9;
        EXPECT_EQ(trials[0].has_shear_spring, stiffness > 0) << along;
        if (trials[0].has_shear_spring) ++locked_count;
        if (stiffness == 0) {
            EXPECT_EQ(trials[0].slides_forward, shear(along) > 0) << along;
        }
    }
    EXPECT_GT(locked_count, 0);
    EXPECT_LT(locked_count, 7) << "some slide";
}

// The memory of another step's trials holds their states, which must not reach the next one.
TEST(TrialContacts, BeginAfreshInTheMemoryOfOthers) {
    RestingContacts block(Scene::mohr_coulomb(30));
    dda::PerContact<dda::ContactTrial> memory(5);
    for (dda::ContactTrial& other : memory) {
        other.may_close = false;
        other.bond_broken = other.has_shear_spring = true;
        other.tilt = other.opening = other.held_normal = 1;
    }
    const auto place = memory.data();
    dda::TrialContacts trials(block.problem, block.step.pool, std::move(memory));
    ASSERT_EQ(trials.count(), 2u);
    const dda::TrialContacts afresh(block.problem, block.step.pool);
    for (const int k : {0, 1}) {
        EXPECT_EQ(trials[k].may_close, afresh[k].may_close);
        EXPECT_EQ(trials[k].bond_broken, afresh[k].bond_broken);
        EXPECT_EQ(trials[k].has_shear_spring, afresh[k].has_shear_spring);
        EXPECT_EQ(trials[k].tilt, afresh[k].tilt);
        EXPECT_EQ(trials[k].opening, afresh[k].opening);
        EXPECT_EQ(trials[k].held_normal, afresh[k].held_normal);
    }
    EXPECT_EQ(trials.release().data(), place);
}

TEST(TrialContacts, ASlidingContactHasItsFrictionForceAsALoad) {
    RestingContacts block(Scene::mohr_coulomb(30));
    block.move(-2e-5, 1e-5);
    block.bounds.update();
    block.trials.force_change();
    block.trials.update_active_set();
    EXPECT_FALSE(block.trials[0].has_shear_spring);
    EXPECT_FALSE(block.trials[0].slides_forward);
    EXPECT_NEAR(block.trials[0].friction_force, -1e4 * tan30, 1e-5);
    const dda::Forces linear = block.trials.linear_forces(0, -3e-5, 7e-5);
    EXPECT_NEAR(linear.normal, 3e4, 1e-5) << "follows the opening";
    EXPECT_NEAR(linear.shear, -1e4 * tan30, 1e-5) << "does not follow the shear displacement";
}

// The forces of the linear system are the tangent of the law where a bound hardens, Eq. (102).
TEST(TrialContacts, AreTangentToABoundThatHardens) {
    RestingContacts block(dda::ContinuouslyYielding{radians(30), radians(30), 1e-3});
    block.move(2e-5, 1e-5);
    block.bounds.update();
    EXPECT_TRUE(block.trials.update_active_set());
    EXPECT_FALSE(block.trials[0].has_shear_spring);
    EXPECT_GT(block.trials[0].sliding_stiffness, 0);
    for (const double way : {2e-5, 1.9e-5, 3e-5}) {
        block.move(way, 1e-5);
        EXPECT_LE(block.trials.force_change().largest, 1e-9) << way;
    }
    block.move(1e-7, 1e-5);
    EXPECT_GT(block.trials.force_change().largest, 1e2) << "locked there";
}

}  // namespace
}  // namespace rockslope::trial_contacts_test
