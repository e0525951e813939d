// A block on a floor: what its two contacts bear at a displacement, and what that makes of the active set.

#include "dda/trial/trial_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
    block.trials.update_bounds();
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
    block.trials.update_bounds();
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
    dda::TrialContacts trials(block.problem, block.step.pool);
    ASSERT_FALSE(trials.has_normal_spring(0));
    const std::vector<Vec6> d{RestingContacts::displacement(2e-6, 1e-5)};
    trials.set_displacement(d, d);
    trials.update_bounds();
    const auto before = trials.force_change();
    EXPECT_NEAR(before.largest, 1e4, 1e-5);
    EXPECT_TRUE(before.contact.exists());
    EXPECT_NEAR(trials.tolerance(), block.step.control.force_tolerance * 1e4, 1e-9);
    EXPECT_TRUE(trials.update_active_set());
    EXPECT_TRUE(trials.has_normal_spring(0));
    EXPECT_TRUE(trials.has_shear_spring(0));
    trials.set_displacement(d, d);
    EXPECT_NEAR(trials.force_change().largest, 0, 1e-9);
    EXPECT_FALSE(trials.update_active_set());
}

TEST(TrialContacts, ASlidingContactHasItsFrictionForceAsALoad) {
    RestingContacts block(Scene::mohr_coulomb(30));
    block.move(-2e-5, 1e-5);
    block.trials.update_bounds();
    block.trials.force_change();
    block.trials.update_active_set();
    EXPECT_FALSE(block.trials.has_shear_spring(0));
    EXPECT_FALSE(block.trials.slides_forward(0));
    EXPECT_NEAR(block.trials.friction_force(0), -1e4 * tan30, 1e-5);
    const dda::Forces linear = block.trials.linear_forces(0, -3e-5, 7e-5);
    EXPECT_NEAR(linear.normal, 3e4, 1e-5) << "follows the opening";
    EXPECT_NEAR(linear.shear, -1e4 * tan30, 1e-5) << "does not follow the shear displacement";
}

// Two corners meet. The upper block moves by (1, 2) mm into the other one's corner: the gaps are -1 mm along
// x and -2 mm along y, and the line along x is crossed last.
TEST(TrialContacts, OnlyTheFirstEntranceMayClose) {
    Scene s;
    s.box({-1, -1}, 1, 1, dda::Motion::fixed);
    s.box({0, 0}, 1, 1);
    for (const double inherited : {0.0, 1e-3}) {
        FirstStep step(s.model);
        ASSERT_EQ(step.set.contacts.size(), 2u);
        const int along_x = std::abs(step.set.contacts[0].normal.x()) > 0.5 ? 0 : 1;
        // Twice the inherited penetration counts as gap: now the line along y is crossed last.
        step.found.set.contacts[1 - along_x].inherited_penetration = inherited;
        const dda::StepProblem problem = step.problem();
        dda::TrialContacts trials(problem, step.pool);
        const std::vector<Vec6> d{(Vec6() << -1e-3, -2e-3, 0, 0, 0, 0).finished()};
        trials.set_displacement(d, d);
        trials.select_first_entrances();
        EXPECT_EQ(trials.may_close(along_x), inherited == 0);
        EXPECT_EQ(trials.may_close(1 - along_x), inherited > 0);
    }
}

TEST(TrialContacts, ABoltYieldsAtItsYieldForce) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    const int anchor = s.material_point(0, {0.5, -0.5}), head = s.material_point(1, {0.5, 0.5});
    s.model.bolts.push_back({"bolt", anchor, head, 1e7, 1e3, 3e3});
    RestingContacts block(s);
    for (const auto& [raised, force, elastic] :
         {std::tuple{1e-4, 2e3, true}, {5e-4, 3e3, false}, {-9e-4, -3e3, false}}) {
        block.move(0, -raised);
        EXPECT_NEAR(block.trials.bolt_force(0), force, 1e-6);
        block.trials.update_active_set();
        EXPECT_EQ(block.trials.is_elastic(0), elastic) << raised;
    }
    EXPECT_NEAR(block.trials.linear_bolt_force(0, 1), -3e3, 1e-9) << "a yielding bolt is a load";
}

}  // namespace
}  // namespace rockslope::trial_contacts_test
