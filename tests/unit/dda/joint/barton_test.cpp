#include "dda/joint/barton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/cyclic_joints.hpp"

namespace rockslope::barton_test {
namespace {

using dda::BartonStrength;

constexpr double degree = 0.017453292519943295;
const BartonStrength granite = joint_tests::granite_strength();
const BartonStrength marble = joint_tests::marble_strength();

// The paper gives peaks to three digits and the angles can be worked out by hand: 12.8 log10(151) = 27.891.
TEST(BartonStrength, IsThatOfThePapersJoints) {
    EXPECT_NEAR(granite.roughness_angle(1e6, 1) / degree, 27.891, 5e-4);
    EXPECT_NEAR(marble.roughness_angle(0.5e6, 1) / degree, 27.843, 5e-4);
    EXPECT_NEAR(granite.shear_strength(1e5, 0.1, 1) * 10, 1.92024e6, 5);
    EXPECT_NEAR(marble.shear_strength(5e4, 0.1, 1) * 10, 1.13060e6, 5);
}

TEST(BartonStrength, IsAForceForTheLengthItActsOn) {
    EXPECT_DOUBLE_EQ(granite.shear_strength(2e6, 2, 0.7), 2 * granite.shear_strength(1e6, 1, 0.7));
}

TEST(BartonStrength, RoughnessVanishesAtTheWallsStrengthAndStaysAway) {
    EXPECT_EQ(granite.roughness_angle(151e6, 1), 0);
    EXPECT_EQ(granite.roughness_angle(1e12, 1), 0);
    EXPECT_DOUBLE_EQ(granite.shear_strength(1e9, 1, 1), 1e9 * std::tan(34.6 * degree));
}

TEST(BartonStrength, TotalAngleIsFromZeroTo70Degrees) {
    // The cap is reached at sigma = JCS 10^-(35.4/12.8) = 0.2593 MPa.
    EXPECT_DOUBLE_EQ(granite.shear_strength(0.2e6, 1, 1), 0.2e6 * std::tan(70 * degree));
    EXPECT_LT(granite.shear_strength(0.26e6, 1, 1), 0.26e6 * std::tan(70 * degree));
    EXPECT_EQ(granite.shear_strength(1e3, 1, -1), 0) << "friction is never negative";
}

TEST(BartonStrength, NothingWithoutCompressionAndFiniteForACorner) {
    for (const double normal : {-1e9, -1e-12, 0.0}) EXPECT_EQ(granite.shear_strength(normal, 1, 1), 0);
    EXPECT_DOUBLE_EQ(granite.shear_strength(1e5, 0, 1), 1e5 * std::tan(34.6 * degree));
    const double tiny = std::numeric_limits<double>::denorm_min();
    EXPECT_TRUE(std::isfinite(granite.roughness_angle(tiny, 1e12)));
}

TEST(BartonStrength, SlopeIsTheTangentBeyondTheLimits) {
    EXPECT_DOUBLE_EQ(granite.slope(0.1e6, 1, 1), std::tan(70 * degree));
    EXPECT_DOUBLE_EQ(granite.slope(1e9, 1, 1), std::tan(34.6 * degree));
    EXPECT_EQ(granite.slope(-1, 1, 1), 0);
}

}  // namespace
}  // namespace rockslope::barton_test
