#include "dda/joint/weakening.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/shear_step.hpp"

namespace rockslope::weakening_test {
namespace {

using dda::JointLaw;
using dda::ShearedJoint;
using dda::Weakening;

constexpr double degree = 0.017453292519943295;
const Weakening linear{40 * degree, 20 * degree, 2e5, 1e4, 5e-3, false};
constexpr double force = 1e5, length = 0.1, stiffness = 8e7;
const double peak = 1e5 * std::tan(40 * degree) + 2e4, residual = 1e5 * std::tan(20 * degree) + 1e3;

ShearedJoint sheared(const Weakening& law, double displacement, double k = stiffness) {
    return dda::shear(JointLaw(law), {dda::fresh_history(JointLaw(law), true)}, displacement,
                      {force, length, k});
}

// The spring unloads while the joint weakens by h per metre: k u + peak - h u = k s.
TEST(Weakening, FallsLinearlyWithTheSlip) {
    const double h = (peak - residual) / 5e-3, s = 3e-3;
    const double u = (stiffness * s - peak) / (stiffness - h);
    ASSERT_LT(u, 5e-3);
    EXPECT_NEAR(sheared(linear, s).slip, u, 1e-15);
    EXPECT_NEAR(sheared(linear, s).shear_force, peak - h * u, 1e-8);
    EXPECT_NEAR(sheared(linear, 0.05).shear_force, residual, 1e-8);
}

TEST(Weakening, FallsLikeAnExponential) {
    Weakening law = linear;
    law.exponential = true;
    const ShearedJoint joint = sheared(law, 4e-3);
    EXPECT_NEAR(joint.shear_force, residual + (peak - residual) * std::exp(-joint.slip / 5e-3), 1e-8);
    EXPECT_NEAR(stiffness * (4e-3 - joint.slip), joint.shear_force, 1e-8);
}

// Softer than the joint weakens, the spring cannot hold it: it slips on until the strength falls no more.
TEST(Weakening, ASoftSpringDropsToResidualAtOnce) {
    const double soft = 0.5 * (peak - residual) / 5e-3;
    const double s = peak / soft * 1.0001;
    EXPECT_NEAR(sheared(linear, s, soft).shear_force, residual, 1e-6);
}

TEST(Weakening, SlipBothWaysCountsAndFacesThatMetLaterAreWeak) {
    const Weakening::History worn = linear.advance(linear.fresh(true), {-2e-3, -2e-3, force, length});
    EXPECT_EQ(linear.advance(worn, {1e-3, 1e-3, force, length}).slip, 3e-3);
    EXPECT_NEAR(linear.strength(linear.fresh(false), force, length, {}).forward, residual, 1e-9);
    EXPECT_NEAR(linear.strength(linear.fresh(true), -force, length, {}).forward, 2e4, 1e-9) << "cohesion";
    EXPECT_EQ(linear.strength(linear.fresh(true), force, 0, {}).tensile, 0);
}

}  // namespace
}  // namespace rockslope::weakening_test
