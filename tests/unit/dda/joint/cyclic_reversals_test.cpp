// Irregular paths of the cyclic joint, as an earthquake's, against values worked out by hand from Eqs. (57)
// to (64). Granite at 1 MPa, displacements in mm; tau(r) and open(r) are strength and dilation angle at a
// ratio r, k is the spring to the peak. A turn between the bounds tau(a) and -tau(b) takes (tau(a) + tau(b))
// / k. Those of the second cycle are in cyclic_second_cycle_test.cpp, those of marble in
// cyclic_marble_test.cpp.

#include <gtest/gtest.h>

#include <cmath>

#include "dda/joint/shear_step.hpp"
#include "dda/joint/shear_test.hpp"
#include "support/cyclic_joints.hpp"
#include "support/cyclic_reference.hpp"

namespace rockslope::cyclic_reversals_test {
namespace {

using dda::CyclicBartonBandis;
using dda::JointStage;
using dda::ShearTestRow;
using joint_tests::expect_opening;
using joint_tests::expect_stress;
using joint_tests::granite;
using joint_tests::reference_granite;

constexpr double mm = joint_tests::ReferenceJoint::mm, length = 0.1;

class CyclicReversals : public testing::Test, protected joint_tests::ReferenceJoint {
  protected:
    CyclicReversals() : ReferenceJoint(reference_granite()) {}
    const double k = shear_stiffness();  ///< Pa/m
};

std::vector<ShearTestRow> rows(const CyclicBartonBandis& law, const std::vector<double>& path) {
    return joint_tests::sheared(law, 1e6, path);
}
ShearTestRow end_of(const CyclicBartonBandis& law, const std::vector<double>& path) {
    return rows(law, path).back();
}

// Before the peak the joint is locked on every path: the force is k d, and the peak is reached at the end.
// The dilation is that of the displacement, by the mean over the table with its ratio x, on every way.
TEST_F(CyclicReversals, BeforeThePeakTheForceIsThatOfTheSpring) {
    const auto out = [this](double d) { return opening(0, d / 1.25, d * mm); };
    const auto turned = rows(granite(), {0.6, 0.2, 0.9, 1.25});
    for (const auto& row : turned) EXPECT_NEAR(row.shear_stress, k * row.displacement, 1e-3);
    expect_opening(turned[0], turned[1], out(0.6));
    expect_opening(turned[1], turned[2], out(0.2) - out(0.6));
    expect_opening(turned[2], turned[3], out(0.9) - out(0.2));
    expect_opening(turned[3], turned[4], out(1.25) - out(0.9));
    EXPECT_EQ(turned[4].record.reversals, 0);
}

// The same across the origin: a joint that has never slipped climbs its table on either side.
TEST_F(CyclicReversals, BeforeThePeakAcrossTheOrigin) {
    const auto out = [this](double d) { return opening(0, d / 1.25, d * mm); };
    const auto turned = rows(granite(), {0.4, -0.3, 1.25});
    for (const auto& row : turned) EXPECT_NEAR(row.shear_stress, k * row.displacement, 1e-3);
    expect_opening(turned[1], turned[2], out(0.3) - out(0.4));
    expect_opening(turned[2], turned[3], out(1.25) - out(0.3));
    EXPECT_EQ(turned[3].record.cycle, 1);
    EXPECT_EQ(turned[3].record.reversals, 0);
}

// In the forward unloading. Out to 5 mm, x = 4 and ratio 0.3; half a millimetre back is less than the turn
// takes, so the force comes down the spring and up again, and the joint opens by as much as it closed: on the
// way out the worn ratio is 0.3 too. At 7.5 mm, x = 6, the table has 0.225.
TEST_F(CyclicReversals, InTheUnloading) {
    const auto turned = rows(granite(), {5, 4.5, 5, 7.5});
    expect_stress(turned[2], tau(0.3) - k * 0.5 * mm);
    EXPECT_EQ(turned[2].record.stage, JointStage::forward_unloading);
    expect_opening(turned[1], turned[2], -0.5 * mm * rate(0.3));
    expect_stress(turned[3], tau(0.3));
    expect_opening(turned[2], turned[3], 0.5 * mm * rate(0.3));
    expect_stress(turned[4], tau(0.225));
    expect_opening(turned[3], turned[4], opening(0.3, 0.225, 2.5 * mm));
    EXPECT_EQ(turned[4].record.reversals, 0);
}

// In the forward return, sliding at -tau(-0.3). 0.4 mm out again is all spring: it opens at the worn ratio,
// 0.3 of the farthest point, and closes at the same on the way back, after which the joint slides on: at -0.3
// to x = 2, from there towards -0.38 at x = 1, so -0.332 at 2 mm.
TEST_F(CyclicReversals, InTheReturn) {
    const auto turned = rows(granite(), {5, 3, 3.4, 2});
    expect_stress(turned[2], -tau(-0.3));
    EXPECT_EQ(turned[2].record.stage, JointStage::forward_return);
    expect_stress(turned[3], -tau(-0.3) + k * 0.4 * mm);
    EXPECT_EQ(turned[3].record.stage, JointStage::forward_advance);
    expect_opening(turned[2], turned[3], 0.4 * mm * rate(0.3));
    expect_stress(turned[4], -tau(-0.332));
    expect_opening(turned[3], turned[4],
                   -0.4 * mm * rate(0.3) - 0.5 * mm * rate(0.3) - opening(0.3, 0.332, 0.5 * mm));
    EXPECT_EQ(turned[4].record.reversals, 1);
}

// In the backward advance at -10 mm, x = 8 and ratio 0.2, back to -7 mm, where the return has -0.3, and out
// again: the worn ratio is 0.2 up to -10 mm. Beyond, at x = 12, the table has 0.2 - 0.05 / 3.
TEST_F(CyclicReversals, InTheBackwardAdvance) {
    const double turn = (tau(0.2) + tau(-0.3)) / k;
    ASSERT_LT(turn, 3 * mm);
    const auto turned = rows(granite(), {15, -10, -7, -10, -15});
    expect_stress(turned[2], -tau(0.2));
    expect_stress(turned[3], tau(-0.3));
    EXPECT_EQ(turned[3].record.stage, JointStage::backward_return);
    expect_opening(turned[2], turned[3], -turn * rate(0.2) - (3 * mm - turn) * rate(0.3));
    expect_stress(turned[4], -tau(0.2));
    expect_opening(turned[3], turned[4], 3 * mm * rate(0.2));
    expect_stress(turned[5], -tau(0.2 - 0.05 / 3));
    expect_opening(turned[4], turned[5], opening(0.2, 0.2 - 0.05 / 3, 5 * mm));
    EXPECT_EQ(turned[5].record.reversals, 3);
}

// In the backward return, as in the forward one: 0.4 mm of spring, at the worn 0.2 both ways, then on at 0.3.
TEST_F(CyclicReversals, InTheBackwardReturn) {
    const auto turned = rows(granite(), {15, -10, -7, -7.4, -6});
    expect_stress(turned[4], tau(-0.3) - k * 0.4 * mm);
    EXPECT_EQ(turned[4].record.stage, JointStage::backward_advance);
    expect_opening(turned[3], turned[4], 0.4 * mm * rate(0.2));
    expect_stress(turned[5], tau(-0.3));
    expect_opening(turned[4], turned[5], -0.4 * mm * rate(0.2) - 1 * mm * rate(0.3));
    EXPECT_EQ(turned[5].record.reversals, 2);
}

// Half a millimetre behind the origin and back. The backward advance goes from -0.4 at the origin to 0.5 at x
// = 1, and has -0.04 at x = 0.4. It turns there, and the locked joint does not dilate, for its roughness
// helps it. Ahead of the origin the roughness is worn to the 0.15 of 15 mm, and the spring, 1 mm from
// -tau(-0.04), has just met it.
TEST_F(CyclicReversals, AcrossTheOriginAndBack) {
    ASSERT_GT(1 * mm * k - tau(-0.04), tau(0.15));
    ASSERT_LT(1 * mm * k - tau(-0.04) - tau(0.15), 0.1 * mm * k) << "no reversal";
    const auto turned = rows(granite(), {15, 0, -0.5, 0, 0.5});
    expect_stress(turned[3], -tau(-0.04));
    expect_opening(turned[2], turned[3], opening(-0.4, -0.04, 0.5 * mm));
    expect_stress(turned[4], -tau(-0.04) + k * 0.5 * mm);
    expect_opening(turned[3], turned[4], 0);
    expect_stress(turned[5], tau(0.15));
    expect_opening(turned[4], turned[5], (1 * mm - (tau(-0.04) + tau(0.15)) / k) * rate(0.15));
    EXPECT_EQ(turned[5].record.cycle, 1);
    EXPECT_EQ(turned[5].record.reversals, 1);
}

// Out to 6 mm, x = 4.8 and ratio 0.27, and behind the origin to -1 mm, too little for a cycle. The lock up to
// the peak belongs to the first advance: this one has the table from the origin on, up to the worn 0.27 at
// 0.3375 mm, in strength and in dilation. The spring comes from tau(-0.4) at the origin, where the joint does
// not dilate, and has met the table before 0.305 mm; with the worn ratio alone it would bear 1.06 % of the
// peak more there.
TEST_F(CyclicReversals, OnlyTheFirstAdvanceIsLockedUpToThePeak) {
    const double slope = 1 / 1.25;  // 1/mm, of the table
    double met = 0;
    for (int n = 0; n < 60; ++n) met = (tau(slope * met) - tau(-0.4)) / (k * mm);
    ASSERT_LT(met, 0.305);
    const auto turned = rows(granite(), {6, -1, 0, 0.305, 1});
    expect_stress(turned[3], tau(-0.4));
    expect_stress(turned[4], tau(slope * 0.305));
    EXPECT_NEAR((tau(-0.4) + k * 0.305 * mm - tau(slope * 0.305)) / tau(1), 0.0106, 5e-5);
    expect_opening(turned[3], turned[4], opening(slope * met, slope * 0.305, (0.305 - met) * mm));
    expect_stress(turned[5], tau(0.27));
    expect_opening(turned[4], turned[5],
                   opening(slope * 0.305, 0.27, 0.0325 * mm) + 0.6625 * mm * rate(0.27));
    EXPECT_EQ(turned[5].record.cycle, 1);
}

// Turns within the spring change nothing. Turns with slip add two reversals each, but no dilation: at
// constant ratios, 0.3 in both directions, the path closes. The rest is the path without turns, times the
// wear.
TEST_F(CyclicReversals, SmallCyclesAndThenABigOne) {
    std::vector<double> within = {5}, slipping = {5};
    for (int n = 0; n < 10; ++n) within.insert(within.end(), {4.6, 5});
    for (int n = 0; n < 3; ++n) slipping.insert(slipping.end(), {3.5, 5});
    auto wearing = granite();
    wearing.reversal_factor = 0.9;
    const double f = std::pow(0.9, 6);
    expect_stress(end_of(wearing, within), tau(0.3));
    expect_stress(end_of(granite(), slipping), tau(0.3));
    expect_stress(end_of(wearing, slipping), tau(f * 0.3));
    EXPECT_EQ(end_of(wearing, slipping).record.reversals, 6);
    const std::vector<double> big = {15, -15, 0};
    auto after_within = within, after_slipping = slipping;
    after_within.insert(after_within.end(), big.begin(), big.end());
    after_slipping.insert(after_slipping.end(), big.begin(), big.end());
    const auto plain = end_of(granite(), big);
    for (const auto& path : {after_within, after_slipping}) {
        const auto row = end_of(granite(), path);
        expect_stress(row, plain.shear_stress);
        EXPECT_NEAR(row.dilation, plain.dilation, 1e-13);
        EXPECT_EQ(row.record.reversals, plain.record.reversals + (path == after_within ? 0 : 6));
    }
    expect_stress(end_of(wearing, {5, 3.5, 5, 3.5, 5, 3.5, 5, 15}), tau(f * 0.15));
}

// Slip of less than min_slip, 0.1 mm, is no reversal and wears nothing: at 6 mm, x = 4.8, the table's 0.27. A
// micron more, and the way back is one and the way out another.
TEST_F(CyclicReversals, SmallerThanMinSlip) {
    auto law = granite();
    law.reversal_factor = 0.9;
    const double turn = (tau(0.3) + tau(-0.3)) / k / mm;
    const auto less = rows(law, {5, 5 - turn - 0.099, 6});
    expect_stress(less[2], -tau(-0.3));
    expect_stress(less[3], tau(0.27));
    EXPECT_EQ(less[3].record.reversals, 0);
    // Counted with a micron to go: the bound has become -tau(-0.27), beyond the spring's reach.
    const auto more = rows(law, {5, 5 - turn - 0.101, 6});
    expect_stress(more[2], -tau(-0.3) - k * 0.001 * mm);
    EXPECT_EQ(more[2].record.reversals, 1);
    expect_stress(more[3], tau(0.81 * 0.27));
    EXPECT_EQ(more[3].record.reversals, 2);
}

// The slip back at -tau(-0.3) until it turns; a slip forward ends it. Once it has counted it goes on growing.
TEST_F(CyclicReversals, TheCounterSlipIsThatSinceTheTurn) {
    auto law = granite();
    law.reversal_factor = 0.9;
    const double turn = (tau(0.3) + tau(-0.3)) / k / mm;
    const auto counter_slip = [&](const std::vector<double>& path) {
        return end_of(law, path).record.counter_slip;
    };
    EXPECT_EQ(counter_slip({5}).amount, 0);
    EXPECT_EQ(counter_slip({5}).least, 0.1 * mm);
    EXPECT_EQ(counter_slip({5, 4.6}).amount, 0) << "locked";
    EXPECT_NEAR(counter_slip({5, 5 - turn - 0.06}).amount, 0.06 * mm, 1e-15);
    EXPECT_FALSE(counter_slip({5, 5 - turn - 0.06}).counted);
    EXPECT_EQ(counter_slip({5, 5 - turn - 0.06, 6}).amount, 0);
    // Counted after 0.1 mm: the bound becomes -tau(-0.27), and the spring needs a little to reach it.
    const double step = (tau(-0.27) - tau(-0.3)) / k / mm;
    const auto counted = counter_slip({5, 5 - turn - 0.1 - step - 0.2});
    EXPECT_TRUE(counted.counted);
    EXPECT_NEAR(counted.amount, 0.3 * mm, 1e-15);
    EXPECT_FALSE(counter_slip({5, 5 - turn - 0.1 - step - 0.2, 6}).amount == counted.amount);
    EXPECT_EQ(end_of(granite(), {5, 3}).record.counter_slip.least, 0) << "reversals do not wear it";
}

// Out again after a reversal: the wear is that of one until the slip forward counts, then that of two, and
// the strength drops at that.
TEST_F(CyclicReversals, TheSecondCountsOnItsOwnWay) {
    auto law = granite();
    law.reversal_factor = 0.9;
    const double back = 5 - (tau(0.3) + tau(-0.3)) / k / mm - 1;
    const double turn = (tau(0.27) + tau(-0.27)) / k / mm;
    expect_stress(end_of(law, {5, back}), -tau(-0.27));
    const auto before = end_of(law, {5, back, back + turn + 0.06});
    expect_stress(before, tau(0.27));
    EXPECT_EQ(before.record.reversals, 1);
    const auto after = end_of(law, {5, back, back + turn + 0.14});
    expect_stress(after, tau(0.81 * 0.3));
    EXPECT_EQ(after.record.reversals, 2);
}

/// A joint of 0.1 m at 5 mm, sliding under 1 MPa, on a spring of 1.5e8 N/m per metre.
constexpr double stiffness = 1.5e8;
dda::ShearedJoint slid() {
    return dda::shear(granite(), {dda::fresh_history(granite(), true)}, 5 * mm, {1e5, length, stiffness});
}
/// N per metre, under another stress, MPa.
double bearing(double ratio, double megapascals) {
    return length * reference_granite(megapascals).tau(ratio);
}

// The pressure doubles as the joint turns: the force takes up where it was, and meets the bound of the new
// stress. The locked joint bears the new pressure on its slope, and contracts with it; the angle of the slip
// is that of the new stress, at which the spring is found anew.
TEST_F(CyclicReversals, UnderMorePressure) {
    const auto there = slid();
    ASSERT_NEAR(there.shear_force, bearing(0.3, 1), 1e-4);
    const double turn = (there.shear_force + 1e5 * rate(0.3) + bearing(-0.3, 2)) / stiffness;
    ASSERT_LT(turn, 2 * mm);
    const auto back = dda::shear(granite(), there, -2 * mm, {2e5, length, stiffness});
    EXPECT_NEAR(back.shear_force, -bearing(-0.3, 2), 1e-4);
    EXPECT_NEAR(back.slip - there.slip, turn - 2 * mm, 1e-15);
    EXPECT_NEAR(dda::dilation(granite(), back.history) - dda::dilation(granite(), there.history),
                -turn * rate(0.3) - (2 * mm - turn) * reference_granite(2).rate(0.3), 1e-13);
    EXPECT_EQ(dda::record(granite(), back.history).reversals, 1);
}

// It halves as the joint turns, and the force with it by the slope: the bound comes down on the force, which
// makes the joint slip on the way it went before, though it is moved back by 10 um. That is no reversal; the
// way back from there is that of the new force.
TEST_F(CyclicReversals, UnderLessPressure) {
    const auto there = slid();
    const double held = bearing(0.3, 0.5);
    const auto let_go = dda::shear(granite(), there, -0.01 * mm, {5e4, length, stiffness});
    EXPECT_NEAR(let_go.shear_force, held, 1e-4);
    EXPECT_NEAR(let_go.slip - there.slip,
                (there.shear_force - 5e4 * rate(0.3) - held) / stiffness - 0.01 * mm, 1e-15);
    EXPECT_EQ(dda::record(granite(), let_go.history).reversals, 0);
    const double turn = (held + bearing(-0.3, 0.5)) / stiffness;
    const auto back = dda::shear(granite(), let_go, -turn - 0.05 * mm, {5e4, length, stiffness});
    EXPECT_NEAR(back.shear_force, -bearing(-0.3, 0.5), 1e-4);
    EXPECT_NEAR(back.slip - let_go.slip, -0.05 * mm, 1e-15);
    EXPECT_EQ(dda::record(granite(), back.history).reversals, 0);
}

}  // namespace
}  // namespace rockslope::cyclic_reversals_test
