#include "dda/joint/velocity_weakening.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/shear_step.hpp"

namespace rockslope::velocity_weakening_test {
namespace {

using dda::ContactMotion;
using dda::JointLaw;
using dda::ShearedJoint;
using dda::VelocityWeakening;

constexpr double degree = 0.017453292519943295;
constexpr double force = 1e5, length = 0.1, stiffness = 1e8;
const VelocityWeakening smooth{35 * degree, 20 * degree, 0.1, 0};
const VelocityWeakening logarithmic{35 * degree, 20 * degree, 1e-3, 0.02};

double friction(const VelocityWeakening& law, double speed) {
    return law.strength({speed}, force, length).forward / force;
}

TEST(VelocityWeakening, FallsFromRestToTheLeast) {
    EXPECT_EQ(friction(smooth, 0), std::tan(35 * degree));
    EXPECT_NEAR(friction(smooth, 0.1), 0.48766503, 1e-8) << "by all but 1/e of the way";
    EXPECT_NEAR(friction(smooth, 10), std::tan(20 * degree), 1e-15);
    EXPECT_EQ(smooth.strength({0.1}, -force, length).forward, 0);
    EXPECT_EQ(smooth.strength({0.1}, force, 0).forward, smooth.strength({0.1}, force, length).backward);
}

// A hundred times the speed costs b ln(100) where both are well above v_c: 1.01 and 101 times it.
TEST(VelocityWeakening, FallsWithTheLogarithmOfTheSpeed) {
    EXPECT_NEAR(friction(logarithmic, 0.099) - friction(logarithmic, 9.999), 0.02 * std::log(100), 1e-14);
    EXPECT_NEAR(friction(logarithmic, 1e-3), std::tan(35 * degree) - 0.02 * std::log(2), 1e-15);
    EXPECT_EQ(friction(logarithmic, 1e30), std::tan(20 * degree));
}

// Sheared at a constant speed the joint slips at that speed, in however many steps; it heals at rest.
TEST(VelocityWeakening, TheSpeedIsThatOfTheLastStep) {
    const JointLaw law = smooth;
    const double speed = 0.05;
    for (const double step : {1e-2, 2e-3, 2e-4}) {
        ShearedJoint joint{dda::fresh_history(law, true)};
        for (int k = 0; k < std::lround(0.1 / step); ++k)
            joint = dda::shear(law, joint, speed * step, {force, length, stiffness, dda::StepTime(step)});
        EXPECT_NEAR(joint.shear_force, force * friction(smooth, speed), 1e-9 * force) << step;
        joint = dda::shear(law, joint, 0, {force, length, stiffness, dda::StepTime(step)});
        EXPECT_NEAR(dda::strength(law, joint.history, force, length).forward, force * friction(smooth, 0),
                    1e-9 * force);
    }
}

TEST(VelocityWeakening, AStaticStepHasNoSpeed) {
    EXPECT_EQ(smooth.advance({0.3}, {1e-3, 1e-3, force, length}).speed, 0);
    const ContactMotion backward{-1e-3, -1e-3, force, length, false, 0, stiffness, dda::StepTime(0.01)};
    EXPECT_EQ(smooth.advance({}, backward).speed, 0.1);
    const ContactMotion far{1e300, 1e300, force, length, false, 0, stiffness, dda::StepTime(1e-300)};
    EXPECT_TRUE(std::isfinite(smooth.advance({}, far).speed));
}

TEST(VelocityWeakening, RecordHoldsTheRemainingFraction) {
    EXPECT_EQ(smooth.record({}).mobilised_ratio, 1);
    EXPECT_NEAR(smooth.record({0.1}).mobilised_ratio, std::exp(-1), 1e-15);
    EXPECT_EQ(VelocityWeakening({0.5, 0.5, 0.1, 0}).record({}).mobilised_ratio, 0) << "none to lose";
}

}  // namespace
}  // namespace rockslope::velocity_weakening_test
