#include "dda/joint/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/joint_law.hpp"

namespace rockslope::mohr_coulomb_test {
namespace {

using dda::MohrCoulomb;
using dda::Strength;

constexpr double degree = 0.017453292519943295;
/// phi 30, c 0.1 MPa, tensile strength 50 kPa; residual phi 20, c 10 kPa.
const MohrCoulomb rough = {30 * degree, 1e5, 5e4, 20 * degree, 1e4};
const MohrCoulomb plain = {30 * degree, 0, 0, 30 * degree, 0};

TEST(MohrCoulomb, IntactJointHasPeakStrength) {
    const Strength s = rough.strength(rough.fresh(true), 2e6, 1.5);
    EXPECT_DOUBLE_EQ(s.forward, 2e6 * std::tan(30 * degree) + 1.5e5);
    EXPECT_DOUBLE_EQ(s.backward, s.forward);
    EXPECT_DOUBLE_EQ(s.tensile, 7.5e4);
}

TEST(MohrCoulomb, BrokenJointHasResidualStrength) {
    const Strength s = rough.strength({true}, 2e6, 1.5);
    EXPECT_DOUBLE_EQ(s.forward, 2e6 * std::tan(20 * degree) + 1.5e4);
    EXPECT_DOUBLE_EQ(s.tensile, 0);
}

TEST(MohrCoulomb, TensionTakesFrictionAwayAndNeverTurnsStrengthNegative) {
    for (const double normal : {-1e12, -1e5, -1.0, -1e-12, 0.0}) {
        const Strength s = rough.strength(rough.fresh(true), normal, 1);
        EXPECT_DOUBLE_EQ(s.forward, std::max(0.0, 1e5 + normal * std::tan(30 * degree))) << normal;
        EXPECT_DOUBLE_EQ(rough.strength({true}, normal, 1).forward, 1e4) << normal;
    }
}

TEST(MohrCoulomb, ABareCornerHasNeitherCohesionNorTension) {
    const Strength s = rough.strength(rough.fresh(true), 1e3, 0);
    EXPECT_DOUBLE_EQ(s.forward, 1e3 * std::tan(30 * degree));
    EXPECT_EQ(s.tensile, 0);
}

TEST(MohrCoulomb, BreaksBySlipInEitherDirectionAndByOpening) {
    const auto intact = rough.fresh(true);
    EXPECT_FALSE(rough.advance(intact, {0, 1e-3, 1e5, 1, false}).broken)
        << "elastic displacement breaks nothing";
    EXPECT_TRUE(rough.advance(intact, {1e-12, 0, 1e5, 1, false}).broken);
    EXPECT_TRUE(rough.advance(intact, {-1e-12, 0, 1e5, 1, false}).broken);
    EXPECT_TRUE(rough.advance(intact, {0, 0, 0, 1, true}).broken);
    EXPECT_TRUE(rough.advance({true}, {0, 0, 1e5, 1, false}).broken) << "and stays broken";
}

TEST(MohrCoulomb, WithoutAPeakNothingCanBreak) {
    EXPECT_TRUE(plain.fresh(true).broken);
    EXPECT_FALSE(rough.fresh(true).broken);
    EXPECT_TRUE(rough.fresh(false).broken) << "faces that met later are not glued";
}

TEST(MohrCoulomb, SmoothJointBearsNoShear) {
    const MohrCoulomb smooth{};
    EXPECT_EQ(smooth.strength(smooth.fresh(true), 1e9, 1).forward, 0);
}

TEST(JointMaterial, OwnPenaltyGoesBeforeTheAnalysis) {
    const dda::JointMaterial common{"common", plain, 0, 0};
    const dda::JointMaterial stiff{"stiff", plain, 7e9, 3e9};
    EXPECT_EQ(common.normal_spring(5e10, 2).stiffness, 5e10);
    EXPECT_EQ(common.shear_spring(4e10, 2), 4e10);
    EXPECT_EQ(stiff.normal_spring(5e10, 2).stiffness, 7e9);
    EXPECT_EQ(stiff.shear_spring(4e10, 2), 3e9);
}

// A closing contact slips below the peak strength, because its cohesion does not act yet.
TEST(MohrCoulomb, SlipOfAClosingContactDoesNotBreakTheJoint) {
    dda::ContactMotion motion;
    motion.slip = 1e-3;
    motion.normal_force = 1e3;
    motion.closing = true;
    EXPECT_FALSE(rough.advance(rough.fresh(true), motion).broken);
    motion.closing = false;
    EXPECT_TRUE(rough.advance(rough.fresh(true), motion).broken);
}

}  // namespace
}  // namespace rockslope::mohr_coulomb_test
