#include "dda/joint/asperity_wear.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/joint_law.hpp"
#include "dda/joint/shear_step.hpp"

namespace rockslope::asperity_wear_test {
namespace {

using dda::JointLaw;
using dda::Plesha;
using dda::ShearedJoint;

constexpr double degree = 0.017453292519943295;
constexpr double force = 1e5, length = 0.1, stiffness = 1e8, stress = 1e6;

ShearedJoint sheared(const JointLaw& law, std::initializer_list<double> displacements) {
    ShearedJoint joint{dda::fresh_history(law, true)};
    for (const double displacement : displacements)
        joint = dda::shear(law, joint, displacement, {force, length, stiffness});
    return joint;
}

// Teeth that do not wear: phi + a on the way up, phi - a on the way down, and a path that closes.
TEST(Plesha, WithoutWearTheTeethAreRiddenUpAndDown) {
    const JointLaw teeth = Plesha{30 * degree, 15 * degree, 0};
    const double up = force * std::tan(45 * degree), down = force * std::tan(15 * degree);
    const ShearedJoint out = sheared(teeth, {0.01});
    EXPECT_NEAR(out.shear_force, up, 1e-8);
    EXPECT_NEAR(out.slip, 0.01 - up / stiffness, 1e-15);
    EXPECT_NEAR(dda::dilation(teeth, out.history), out.slip * std::tan(15 * degree), 1e-15);
    const ShearedJoint back = sheared(teeth, {0.01, -0.005});
    EXPECT_NEAR(back.shear_force, -down, 1e-8);
    EXPECT_NEAR(dda::dilation(teeth, back.history), back.slip * std::tan(15 * degree), 1e-15);
    const ShearedJoint behind = sheared(teeth, {0.01, -0.02});
    EXPECT_NEAR(behind.shear_force, -up, 1e-8) << "up the other side";
}

// The whole displacement of an open joint is slip: it rises and falls with its teeth and wears nothing. What
// its spring had stored is slip, too.
TEST(Plesha, AnOpenJointFollowsItsDisplacement) {
    const Plesha law{30 * degree, 15 * degree, 5e-4};
    const JointLaw teeth = law;
    const ShearedJoint out = sheared(teeth, {0.01});
    const auto& before = std::get<Plesha::History>(out.history);
    const auto moved = [&](double displacement) {
        const ShearedJoint open = dda::shear(teeth, out, displacement, {0, length, stiffness});
        return std::get<Plesha::History>(open.history);
    };
    const double slope = std::tan(15 * degree * std::exp(-5e-4 * before.work));
    const double stored = out.shear_force / stiffness;
    EXPECT_NEAR(moved(0.004).dilation - before.dilation, slope * (0.004 + stored), 1e-15);
    EXPECT_NEAR(moved(-0.004).dilation - before.dilation, -slope * (0.004 - stored), 1e-15);
    EXPECT_EQ(moved(0.004).work, before.work);
    EXPECT_NEAR(moved(0.004).position, 0.014, 1e-17);
    EXPECT_EQ(moved(std::nan("")).position, before.position) << "an iteration that diverges ends";
}

// A locked joint that passes its origin bears more than the strength it would return with. It keeps the
// strength it had, less what its spring has lost, Eq. (82): neither force nor strength jumps.
TEST(Plesha, KeepsItsStrengthBehindTheOrigin) {
    const JointLaw teeth = Plesha{30 * degree, 15 * degree, 0};
    const double up = force * std::tan(45 * degree);
    ShearedJoint joint{dda::fresh_history(teeth, true)};
    joint.shear_force = 0.9 * up;
    joint = dda::shear(teeth, joint, 1e-5, {force, length, stiffness});
    const double before = joint.shear_force;
    for (int k = 1; k <= 60; ++k) {
        const double moved = -1e-6 * k;
        const ShearedJoint next = dda::shear(teeth, joint, moved, {force, length, stiffness});
        EXPECT_NEAR(next.shear_force, before + stiffness * moved, 1e-9 * force) << k;
        const double behind = std::max(-(1e-5 + moved), 0.0);
        EXPECT_NEAR(dda::strength(teeth, joint.history, force, length, {moved, before, stiffness}).forward,
                    up - stiffness * behind, 1e-9 * force)
            << k;
    }
}

// Without friction all the work of shear lifts the normal load: dilation = W / sigma, whatever the wear.
TEST(Plesha, WithoutFrictionTheWorkIsThatOfTheNormalStress) {
    const Plesha smooth{0, 20 * degree, 5e-4};
    const ShearedJoint joint = sheared(smooth, {0.02});
    const auto& history = std::get<Plesha::History>(joint.history);
    EXPECT_GT(smooth.wear * history.work, 0.5) << "it has worn";
    EXPECT_NEAR(history.dilation, history.work / stress, 1e-12 * history.dilation);
}

// dW = sigma tan(phi + a exp(-c W)) dU, so the slip is an integral over the work: here by Simpson's rule.
// The displacements have all sizes, so the last integration step has any length.
TEST(Plesha, SlipIsTheIntegralOverTheWork) {
    const Plesha law{25 * degree, 20 * degree, 3e-4};
    const auto inverse = [&](double work) {
        return 1 / (stress * std::tan(25 * degree + 20 * degree * std::exp(-3e-4 * work)));
    };
    for (int n = 1; n <= 150; ++n) {
        const ShearedJoint joint = sheared(law, {1e-4 * n + 1e-3});
        const auto& history = std::get<Plesha::History>(joint.history);
        const int parts = 2000;
        double integral = inverse(0) + inverse(history.work);
        for (int k = 1; k < parts; ++k) integral += (k % 2 ? 4 : 2) * inverse(history.work * k / parts);
        integral *= history.work / (3 * parts);
        EXPECT_NEAR(joint.slip, integral, 1e-11 * integral) << n;
        EXPECT_NEAR(joint.shear_force,
                    force * std::tan(25 * degree + 20 * degree * std::exp(-3e-4 * history.work)), 1e-4)
            << n;
    }
}

TEST(TwoOrderAsperities, AreTheSumOfTwo) {
    const dda::TwoOrderAsperities one{30 * degree, 15 * degree, 2e-4, 0, 0};
    EXPECT_EQ(sheared(one, {0.01}).shear_force,
              sheared(Plesha{30 * degree, 15 * degree, 2e-4}, {0.01}).shear_force);
    const dda::TwoOrderAsperities two{30 * degree, 5 * degree, 0, 10 * degree, 1};
    EXPECT_NEAR(dda::strength(two, dda::fresh_history(two, true), force, length).forward, force, 1e-6)
        << "45 deg";
    EXPECT_NEAR(sheared(two, {0.02}).shear_force, force * std::tan(35 * degree), 1e-6)
        << "only waves are left";
}

TEST(StressedAsperities, AreClimbedLessUnderHigherNormalStress) {
    const dda::StressedAsperities law{30 * degree, 16 * degree, 0, 4e6, 2};
    const auto angle = [&](double at) {
        return std::atan(law.strength(law.fresh(true), at * length, length, {}).forward / (at * length)) /
               degree;
    };
    EXPECT_NEAR(angle(1e-3), 46, 1e-6);
    EXPECT_NEAR(angle(2e6), 34, 1e-9) << "a quarter";
    EXPECT_NEAR(angle(5e6), 30, 1e-9);
}

}  // namespace
}  // namespace rockslope::asperity_wear_test
