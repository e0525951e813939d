// The dilation of a block on a floor whose asperities do not wear. Its joint slips by U with the total normal
// force N and the shear force S of both contacts, whose springs are 2 k each way:
//     U = u - S / 2k,   S = N tan(phi + a),   N = 2k (c + delta),   delta = U tan(a),
// with the displacement u along the joint and c into it. Hence delta = t (u - c T) / (1 + t T), t = tan(a),
// T = tan(phi + a).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/resting_block.hpp"

namespace rockslope::joint_dilation_test {
namespace {

using namespace scene;

constexpr double along = 1e-4, into = 2e-5;  // u and c, m

class JointDilation : public testing::Test {
  protected:
    static constexpr double spring = RestingContacts::spring;
    const double t = std::tan(radians(10)), T = std::tan(radians(30 + 10));
    const double dilation = t * (along - into * T) / (1 + t * T);
    RestingContacts block{dda::Plesha{{radians(30), radians(10), 0}}};

    void solve(double u) {
        block.move(u, into);
        block.contacts.entrances.select_first();
        block.bounds.update();
        block.trials.force_change();  // the largest force scales the tolerance
        block.contacts.dilation.update();
        block.bounds.update();
    }
};

TEST_F(JointDilation, IsThatOfTheSlipUnderItsOwnNormalForce) {
    for (const double direction : {1.0, -1.0}) {
        solve(direction * along);
        for (const dda::EvaluatedContact& contact : block.evaluated()) {
            EXPECT_NEAR(contact.dilation_increment, dilation, 2e-6 * dilation) << direction;
            EXPECT_NEAR(contact.normal_force, spring * (into + dilation), 1e-5 * spring * into);
            EXPECT_NEAR(contact.shear_force, direction * contact.normal_force * T, 1e-5 * spring * into);
        }
    }
}

TEST_F(JointDilation, IsNoneWhereTheJointIsLocked) {
    solve(0.5 * into * std::tan(radians(30)));
    for (const dda::EvaluatedContact& contact : block.evaluated()) {
        EXPECT_EQ(contact.state, dda::ContactState::locked);
        EXPECT_EQ(contact.dilation_increment, 0);
    }
    EXPECT_TRUE(block.contacts.dilation.by_force().empty());
}

// Eq. (83): further slip opens the joint by tan(a), so the normal spring is tilted by it.
TEST_F(JointDilation, TiltsTheNormalSpringOfASlidingContact) {
    for (const double direction : {1.0, -1.0}) {
        solve(direction * along);
        block.trials.update_active_set();
        EXPECT_NEAR(block.trials[0].tilt, direction * t, 1e-5 * t);
        EXPECT_NEAR(block.trials[1].tilt, direction * t, 1e-5 * t);
    }
}

// Eq. (85): at a held displacement dU / dN = -T / 2k.
TEST_F(JointDilation, FollowsTheNormalForceAtAHeldDisplacement) {
    solve(along);
    const auto by_force = block.contacts.dilation.by_force();
    ASSERT_EQ(by_force.size(), 1u);
    EXPECT_EQ(by_force[0].contacts.size(), 2u);
    EXPECT_NEAR(by_force[0].slope, -t * T / (2 * spring), 1e-4 * t * T / (2 * spring));
    EXPECT_NEAR(by_force[0].normal_force, 2 * spring * (into + dilation), 1e-5 * spring * into);
    block.contacts.dilation.set_change(0, 3e-6);
    EXPECT_NEAR(block.evaluated()[0].dilation_increment, dilation + 3e-6, 1e-10);
    block.contacts.dilation.set_change(0, 1e-6);
    EXPECT_NEAR(block.evaluated()[1].dilation_increment, dilation + 1e-6, 1e-10) << "not added to the last";
}

TEST_F(JointDilation, ExceedsTheToleranceUntilItIsUpdated) {
    block.move(along, into);
    block.bounds.update();
    block.trials.force_change();
    EXPECT_TRUE(block.contacts.dilation.exceeds_tolerance());
    solve(along);
    EXPECT_FALSE(block.contacts.dilation.exceeds_tolerance());
}

// Zero is nearer to the law's value than three times that value is: then it acts in the next step.
TEST_F(JointDilation, IsPostponedWhereItIsFartherFromTheLawThanZero) {
    solve(along);
    EXPECT_FALSE(block.contacts.dilation.postpone()) << "it is that of the law";
    block.contacts.dilation.set_change(0, 4 * dilation);
    EXPECT_TRUE(block.contacts.dilation.postpone());
    EXPECT_EQ(block.evaluated()[0].dilation_increment, 0);
    EXPECT_EQ(block.trials[0].tilt, 0);
    EXPECT_TRUE(block.contacts.dilation.by_force().empty());
    solve(along);
    EXPECT_EQ(block.evaluated()[0].dilation_increment, 0) << "for the rest of the step";
    EXPECT_FALSE(block.contacts.dilation.postpone());
}

// A dilation within ten tolerances of forces of the law's is that of the law. Postponing it would solve the
// step once more, and joints that hardly move would be postponed one after the other.
TEST_F(JointDilation, IsNotPostponedWhereItHasSettled) {
    solve(along);
    const double settled = 5 * block.trials.tolerance() / spring;
    for (const double off : {settled, 4 * settled}) {
        solve(into * T + settled / (8 * t) * (1 + t * T));  // the law gives an eighth of it
        block.contacts.dilation.set_change(0, off);
        EXPECT_EQ(block.contacts.dilation.postpone(), off > settled) << off;
    }
}

// Eq. (104) on a joint whose law gives d = -a N, on a block that resists being lifted with K: N = N0 + K d.
// Each plain correction leaves -a K of the excess, so it grows where a K > 1. The response is 1 + a K,
// with which the second correction is exact, and 5 at most.
TEST(DilationCorrection, SettlesADilationThatRaisesItsNormalForce) {
    for (const double gain : {0.5, 3.0, 4.0, 8.0}) {
        SCOPED_TRACE(gain);
        double dilation = 1e-4;
        const auto excess = [&] { return -gain * dilation - dilation; };
        dda::DilationCorrection last;
        for (int update = 0; update < 2; ++update) {
            const double now = excess();
            last = {now, now / last.response(now)};
            dilation += last.correction;
        }
        const double left = 1 - (1 + gain) / std::min(1 + gain, 5.0);
        EXPECT_NEAR(dilation, -gain * 1e-4 * left, 1e-17);
    }
}

TEST(DilationCorrection, TakesTheWholeExcessAtFirstAndWhereItFalls) {
    EXPECT_EQ(dda::DilationCorrection{}.response(2e-6), 1);
    EXPECT_EQ((dda::DilationCorrection{2e-6, 2e-6}.response(1e-6)), 1) << "it falls by less than was moved";
    EXPECT_EQ((dda::DilationCorrection{2e-6, 2e-6}.response(-4e-6)), 3);
}

// Friction takes S u - N dU - ... of a step, no less than nothing: five times the dilation of the law would
// give energy, and what friction does not pay for is left.
TEST_F(JointDilation, IsLimitedWhereFrictionDoesNotPayForIt) {
    solve(along);
    EXPECT_FALSE(block.contacts.dilation.limit()) << "friction pays for that of the law";
    const double of_law = block.evaluated()[0].dilation_increment;
    block.contacts.dilation.set_change(0, 4 * dilation);
    const double given = block.evaluated()[0].dilation_increment;
    EXPECT_TRUE(block.contacts.dilation.limit());
    EXPECT_LT(block.evaluated()[0].dilation_increment, given);
    EXPECT_GE(block.evaluated()[0].dilation_increment, 0);
    EXPECT_GT(given, of_law);
    EXPECT_TRUE(block.contacts.dilation.by_force().empty());
}

/// Even roughness, so that the joint dilates with its displacement, however it goes.
dda::JointLaw even_roughness() {
    dda::CyclicBartonBandis law;
    law.barton = {2, 50e6, radians(18)};
    law.peak_displacement = 2e-3;
    law.damage = 1;
    const dda::RoughnessTable even = {{{0, 1}, {1, 1}}};
    law.cycles = {{even, even, even, even}};
    law.unsigned_ratios = true;
    return law;
}

// A correction is measured at a contact that follows it, not at one whose dilation is postponed.
TEST(JointDilationOfALockedJoint, LeavesOutThePostponedContact) {
    RestingContacts block{even_roughness()};
    const auto update = [&] {
        block.bounds.update();
        block.trials.force_change();
        block.contacts.dilation.update();
    };
    block.move(5e-6, into);
    block.contacts.entrances.select_first();
    update();
    const double followed = block.trials[1].dilation_increment;
    ASSERT_GT(std::abs(followed), 1e-10);
    block.trials[0].postponed = true;
    block.trials[0].dilation_increment += std::copysign(1e-6, followed);
    update();
    EXPECT_NEAR(block.trials[1].dilation_increment, followed, 1e-9);
}

// A locked joint of even roughness dilates with its displacement, however it goes. What is postponed dilates
// with the slope of the locked joint, for its shear force follows the normal force with that slope, too. A
// joint that has not slipped has the mean slope of the way.
TEST(JointDilationOfALockedJoint, KeepsItsSlopeWhereItIsPostponed) {
    RestingContacts block{even_roughness()};
    const double elastic = 5e-6;  // m, a quarter of what the strength under 20 kN bears
    const auto update = [&](double u) {
        block.move(u, into);
        block.contacts.entrances.select_first();
        block.bounds.update();
        block.trials.force_change();
    };
    update(elastic);
    block.contacts.dilation.update();
    block.bounds.update();
    block.trials.update_active_set();
    ASSERT_EQ(block.evaluated()[0].state, dda::ContactState::locked);
    const double slope = block.trials[0].tilt;
    ASSERT_GT(std::abs(slope), 1e-4);
    update(-elastic);  // the tilt continues to three times the law's value, with the other sign
    ASSERT_TRUE(block.contacts.dilation.postpone());
    block.trials.update_active_set();
    EXPECT_EQ(block.trials[0].tilt, slope);
    EXPECT_NEAR(block.evaluated()[0].dilation_increment, -slope * elastic / 2, 1e-9 * elastic);
    update(elastic);
    EXPECT_NEAR(block.evaluated()[0].dilation_increment, 1.5 * slope * elastic, 1e-9 * elastic);
}

}  // namespace
}  // namespace rockslope::joint_dilation_test
