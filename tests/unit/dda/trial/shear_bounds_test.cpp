// The shear bounds of a block on a floor at a displacement.

#include "dda/trial/shear_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/resting_block.hpp"

namespace rockslope::shear_bounds_test {
namespace {

using namespace scene;
using dda::ContactState;

const double tan30 = std::tan(radians(30));

TEST(ShearBounds, SlideAtTheBoundOfTheirLaw) {
    for (const double direction : {1.0, -1.0}) {
        RestingContacts block(Scene::mohr_coulomb(30));
        block.move(direction * 2e-5, 1e-5);
        block.bounds.update();
        for (const dda::EvaluatedContact& contact : block.evaluated()) {
            EXPECT_EQ(contact.state, ContactState::sliding);
            EXPECT_NEAR(contact.shear_force, direction * 1e4 * tan30, 1e-5);
            EXPECT_NEAR(contact.slip, direction * (2e-5 - 1e4 * tan30 / block.spring), 1e-14);
        }
    }
}

TEST(ShearBounds, HaveReducedStrengths) {
    Scene s = resting_block(Scene::mohr_coulomb(30));
    s.model.strength_reduction = 1.25;
    RestingContacts block(s);
    block.move(2e-5, 1e-5);
    block.bounds.update();
    EXPECT_NEAR(block.evaluated()[0].shear_force, 1e4 * tan30 / 1.25, 1e-5);
}

// Eq. (75): cohesion, here 2e4 Pa over 0.5 m, acts in a step at whose start the contact was closed.
TEST(ShearBounds, HaveCohesionOnlyIfTheyWereClosed) {
    for (const bool was_closed : {true, false}) {
        RestingContacts block(dda::MohrCoulomb{radians(30), 2e4, 0, radians(30), 2e4});
        for (dda::Contact& contact : block.step.found.set.contacts)
            contact.state = was_closed ? ContactState::locked : ContactState::open;
        dda::StepContacts contacts(block.problem, block.step.pool);
        const std::vector<Vec6> d{RestingContacts::displacement(1e-4, 1e-5)};
        contacts.trials.set_displacement(d, d);
        contacts.bounds.update();
        std::vector<dda::EvaluatedContact> evaluated(2);
        contacts.trials.evaluate(evaluated);
        EXPECT_NEAR(evaluated[0].shear_force, 1e4 * tan30 + (was_closed ? 1e4 : 0), 1e-5) << was_closed;
    }
}

// A line that is not entered first bears nothing, its cohesion included.
TEST(ShearBounds, HaveNoCohesionWhereTheyMayNotClose) {
    RestingContacts block(dda::MohrCoulomb{radians(30), 2e4, 0, radians(30), 2e4});
    block.step.found.set.contacts[0].inhibited = true;
    for (dda::Contact& contact : block.step.found.set.contacts) contact.state = ContactState::sliding;
    const dda::TrialContacts trials(block.problem, block.step.pool);
    EXPECT_FALSE(trials[0].may_close);
    EXPECT_FALSE(trials.coheres(0));
    EXPECT_TRUE(trials.coheres(1));
}

TEST(ShearBounds, CanBeReadAndSet) {
    RestingContacts block(Scene::mohr_coulomb(30));
    block.move(2e-5, 1e-5);
    block.bounds.update();
    Eigen::VectorXd bounds = block.bounds.values();
    ASSERT_EQ(bounds.size(), 4);
    for (const double bound : bounds) EXPECT_NEAR(bound, 1e4 * tan30, 1e-5);
    bounds << 100, 200, -300, 400;
    block.bounds.set_values(bounds);
    EXPECT_EQ(block.bounds.values()[2], 0) << "negative bounds are none";
    EXPECT_EQ(block.evaluated()[0].shear_force, 100);
    EXPECT_EQ(block.evaluated()[1].shear_force, 0);
    block.move(-2e-5, 1e-5);
    EXPECT_EQ(block.evaluated()[0].shear_force, -200);
    EXPECT_EQ(block.evaluated()[1].shear_force, -400);
}

// A bound that hardens is held as a line over the shear displacement, Eq. (102): near where it was set it is
// that of the law, and it is read and set at no displacement.
TEST(ShearBounds, HardenWithTheShearDisplacement) {
    const dda::ContinuouslyYielding law{radians(30), radians(30), 1e-3};
    const double way = 1e-5;
    RestingContacts block(law);
    block.move(way, 1e-5);
    block.bounds.update();
    const double hardening = block.trials[0].hardening.forward;
    EXPECT_GT(hardening, 0);
    EXPECT_EQ(std::exp2(std::round(std::log2(hardening / block.spring))), hardening / block.spring)
        << "a power of two of the spring";
    const double force = block.evaluated()[0].shear_force;
    const Eigen::VectorXd values = block.bounds.values();
    EXPECT_NEAR(values[0], force - hardening * way, 1e-9 * force);
    block.move(1.1 * way, 1e-5);
    EXPECT_NEAR(block.evaluated()[0].shear_force, force + hardening * 0.1 * way, 1e-9 * force);
    RestingContacts further(law);
    further.move(1.1 * way, 1e-5);
    further.bounds.update();
    const double by_law = further.evaluated()[0].shear_force;
    EXPECT_LT(std::abs(block.evaluated()[0].shear_force - by_law), 0.5 * (by_law - force))
        << "nearer to the law than a bound without hardening";
    block.bounds.set_values(values);
    EXPECT_NEAR(block.evaluated()[0].shear_force, force + hardening * 0.1 * way, 1e-9 * force);
}

// Bounds that are mixed from minimum to minimum keep their slopes: only the laws change them.
TEST(ShearBounds, KeepTheirHardeningWhileItIsHeld) {
    RestingContacts block(dda::ContinuouslyYielding{radians(30), radians(30), 1e-3});
    block.move(1e-5, 1e-5);
    block.bounds.update();
    const double hardening = block.trials[0].hardening.forward;
    const double bound = block.trials[0].bounds.forward;
    block.move(2e-5, 1e-5);
    block.bounds.hold_hardening(true);
    block.bounds.update();
    EXPECT_EQ(block.trials[0].hardening.forward, hardening);
    EXPECT_GT(block.trials[0].bounds.forward, bound);
    block.bounds.hold_hardening(false);
    block.bounds.update();
    EXPECT_LT(block.trials[0].hardening.forward, hardening) << "nearer to the strength";
}

}  // namespace
}  // namespace rockslope::shear_bounds_test
