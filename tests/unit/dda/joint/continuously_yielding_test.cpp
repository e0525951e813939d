#include "dda/joint/continuously_yielding.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/shear_step.hpp"

namespace rockslope::continuously_yielding_test {
namespace {

using dda::ContinuouslyYielding;
using dda::ShearedJoint;

constexpr double degree = 0.017453292519943295;
constexpr dda::JointLoad load{1e5, 0.1, 1e8};

double tangent(double degrees) {
    return std::tan(degrees * degree);
}
const ContinuouslyYielding even{30 * degree, 30 * degree, 1e-3};  // without damage
const ContinuouslyYielding wearing{45 * degree, 30 * degree, 2e-3};

ShearedJoint fresh(const ContinuouslyYielding& law) {
    return {dda::fresh_history(law, true)};
}

// Without damage d tau/ds = k (1 - tau/tau_m): an exponential approach; the plastic displacement is the rest
// after the spring's.
TEST(ContinuouslyYielding, NearsItsBoundExponentially) {
    const double bound = 1e5 * tangent(30), length = bound / 1e8;
    for (const double way : {1e-5, 3e-4, 2e-3}) {
        const ShearedJoint joint = dda::shear(even, fresh(even), way, load);
        const double expected = bound * -std::expm1(-way / length);
        EXPECT_NEAR(joint.shear_force, expected, 1e-9 * bound) << way;
        EXPECT_NEAR(joint.slip, way - expected / 1e8, 1e-12) << way;
    }
}

// The factor r = tau/tau_m of the reversal: the reloading starts with the elastic stiffness and approaches
// the bound over (1 - r) times the length. Unloading is elastic until the force has changed its sign.
TEST(ContinuouslyYielding, UnloadsElasticallyAndReloadsStiff) {
    const double bound = 1e5 * tangent(30);
    const ShearedJoint there = dda::shear(even, fresh(even), 4e-4, load);
    const ShearedJoint back = dda::shear(even, there, -2e-4, load);
    EXPECT_NEAR(back.shear_force, there.shear_force - 2e-4 * 1e8, 1e-9 * bound);
    EXPECT_EQ(back.slip, there.slip);
    const double r = back.shear_force / bound;
    ASSERT_GT(r, 0.1);
    const double way = 1e-4, length = bound * (1 - r) / 1e8;
    EXPECT_NEAR(dda::shear(even, back, way, load).shear_force,
                bound - (bound - back.shear_force) * std::exp(-way / length), 1e-9 * bound);
    const double to_zero = there.shear_force / 1e8;
    EXPECT_NEAR(dda::shear(even, there, -to_zero, load).slip, there.slip, 1e-15);
    EXPECT_NEAR(dda::shear(even, there, -to_zero - 3e-4, load).shear_force,
                -bound * -std::expm1(-3e-4 * 1e8 / bound), 1e-8 * bound);
}

// phi_m = phi + (phi_0 - phi) exp(-u_p/R), Eq. (74): a peak on the way, and the worn friction in the end.
TEST(ContinuouslyYielding, PeaksAndWearsDown) {
    double peak = 0;
    ShearedJoint joint = fresh(wearing);
    for (int k = 0; k < 1000; ++k) {
        joint = dda::shear(wearing, joint, 2e-5, load);
        peak = std::max(peak, joint.shear_force);
        const double plastic = std::get<ContinuouslyYielding::History>(joint.history).plastic;
        EXPECT_NEAR(plastic, joint.slip, 1e-11);
        const dda::Strength s = dda::strength(wearing, joint.history, 1e5, 0.1);
        EXPECT_NEAR(s.backward, 1e5 * tangent(30 + 15 * std::exp(-plastic / 2e-3)), 1e-6);
    }
    EXPECT_GT(peak, 1.05e5 * tangent(30));
    EXPECT_LT(peak, 1e5 * tangent(45));
    EXPECT_NEAR(joint.shear_force, 1e5 * tangent(30), 1e-3 * 1e5);
}

// A sliding joint is at its bound for any stiffness of the spring.
TEST(ContinuouslyYielding, AStiffSpringFollowsTheBound) {
    const ShearedJoint joint = dda::shear(wearing, fresh(wearing), 1e-3, {1e5, 0.1, 1e13});
    EXPECT_NEAR(joint.shear_force, 1e5 * tangent(30 + 15 * std::exp(-0.5)), 1e-5 * 1e5);
    EXPECT_NEAR(joint.slip, 1e-3, 1e-7);
    const ShearedJoint soft = dda::shear(wearing, fresh(wearing), 1e-3, {1e5, 0.1, 1.02e10});
    const ShearedJoint hard = dda::shear(wearing, fresh(wearing), 1e-3, {1e5, 0.1, 0.98e10});
    EXPECT_NEAR(soft.shear_force, hard.shear_force, 1e-3 * 1e5) << "where the integration changes";
}

TEST(ContinuouslyYielding, AFallingNormalForceReducesTheShearForce) {
    const ShearedJoint high = dda::shear(even, fresh(even), 5e-3, load);
    const ShearedJoint low = dda::shear(even, high, 1e-9, {4e4, 0.1, 1e8});
    EXPECT_NEAR(low.shear_force, 4e4 * tangent(30), 1e-3);
    EXPECT_EQ(dda::shear(even, high, 1e-3, {0, 0.1, 1e8}).shear_force, 0);
}

TEST(ContinuouslyYielding, WithoutASpringTheSlipIsPrescribed) {
    const auto history = wearing.advance({}, {3e-3, 3e-3, 1e5, 0.1});
    EXPECT_EQ(history.plastic, 3e-3);
    EXPECT_DOUBLE_EQ(wearing.strength({}, 1e5, 0.1, {2e-3, 0, 0}).forward,
                     1e5 * tangent(30 + 15 * std::exp(-1)));
}

}  // namespace
}  // namespace rockslope::continuously_yielding_test
