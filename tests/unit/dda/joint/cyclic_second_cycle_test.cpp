// Partial and irregular reversals after a full cycle of 15 mm, by hand from Eqs. (57) to (64). Granite at 1
// MPa, displacements in mm, x = d / 1.25; cyclic_reversals_test.cpp explains the letters. The
// tables of the second cycle: forward advance 0.3 x up to x = 1 and 0.3 beyond; return -0.38 + 0.08 x, then
// -0.3; backward advance -0.38 + 0.48 x, 0.1 + 0.2 (x - 1) up to x = 2, then 0.3; return -0.3. The first
// cycle counts two reversals and comes back to the origin at tau(-0.4).

#include <gtest/gtest.h>

#include "dda/joint/shear_test.hpp"
#include "support/cyclic_joints.hpp"
#include "support/cyclic_reference.hpp"

namespace rockslope::cyclic_second_cycle_test {
namespace {

using dda::CyclicBartonBandis;
using dda::JointStage;
using dda::ShearTestRow;
using joint_tests::expect_opening;
using joint_tests::expect_stress;
using joint_tests::granite;

class CyclicSecondCycle : public testing::Test, protected joint_tests::ReferenceJoint {
  protected:
    CyclicSecondCycle() : ReferenceJoint(joint_tests::reference_granite()) {}
    const double k = shear_stiffness();  ///< Pa/m
    /// Where the spring, from a displacement (mm) and a stress (Pa) on, meets the strength of a ratio that is
    /// `ratio` at the origin and rises by `rise` per millimetre, mm.
    double first_met(double displacement, double from_stress, double ratio, double rise) const {
        double met = 0;
        for (int n = 0; n < 60; ++n) met = displacement + (tau(ratio + rise * met) - from_stress) / (k * mm);
        return met;
    }
};

/// From the origin at the second cycle's beginning on, row 0.
std::vector<ShearTestRow> rows(const CyclicBartonBandis& law, const std::vector<double>& path) {
    std::vector<double> whole = {15, -15, 0};
    whole.insert(whole.end(), path.begin(), path.end());
    const auto all = joint_tests::sheared(law, 1e6, whole);
    return {all.begin() + 3, all.end()};
}
CyclicBartonBandis wearing() {
    auto law = granite();
    law.reversal_factor = 0.9;
    return law;
}

// No lock up to a peak: at 0.5 mm, x = 0.4, the joint slides at ratio 0.12. 0.2 mm back and out again are all
// spring, at the ratio of the turning point both ways. At 1 mm the table has 0.24.
TEST_F(CyclicSecondCycle, WithinThePeakDisplacement) {
    const auto turned = rows(granite(), {0.5, 0.3, 1});
    expect_stress(turned[0], tau(-0.4));
    EXPECT_EQ(turned[0].record.cycle, 2);
    expect_stress(turned[1], tau(0.12));
    const double met = first_met(0, tau(-0.4), 0, 0.24);
    expect_opening(turned[0], turned[1], opening(0.24 * met, 0.12, (0.5 - met) * mm));
    expect_stress(turned[2], tau(0.12) - k * 0.2 * mm);
    EXPECT_EQ(turned[2].record.stage, JointStage::forward_unloading);
    expect_opening(turned[1], turned[2], -0.2 * mm * rate(0.12));
    expect_stress(turned[3], tau(0.24));
    expect_opening(turned[2], turned[3], 0.2 * mm * rate(0.12) + opening(0.12, 0.24, 0.5 * mm));
    EXPECT_EQ(turned[3].record.reversals, 2);
}

// From 5 mm, ratio 0.3, back to 0.625 mm, x = 0.5, where the return has -0.34, and the advance 0.15. Out
// again the spring opens it by the latter, to 1.5 mm and beyond. It is sliding again at 2 mm.
TEST_F(CyclicSecondCycle, InTheReturn) {
    const auto turned = rows(granite(), {5, 0.625, 1.5, 2});
    expect_stress(turned[1], tau(0.3));
    const double met = first_met(0, tau(-0.4), 0, 0.24);
    expect_opening(turned[0], turned[1], opening(0.24 * met, 0.3, (1.25 - met) * mm) + 3.75 * mm * rate(0.3));
    expect_stress(turned[2], -tau(-0.34));
    EXPECT_EQ(turned[2].record.stage, JointStage::forward_return);
    expect_opening(turned[1], turned[2], -3.75 * mm * rate(0.3) - opening(0.3, 0.34, 0.625 * mm));
    ASSERT_LT(0.875 * mm, reversal_displacement(0.3, -0.34));
    expect_stress(turned[3], -tau(-0.34) + k * 0.875 * mm);
    expect_opening(turned[2], turned[3], 0.875 * mm * rate(0.15));
    EXPECT_EQ(turned[3].record.reversals, 3);
    expect_stress(turned[4], tau(0.3));
    const double spring = reversal_displacement(0.3, -0.34) - 0.875 * mm;
    expect_opening(turned[3], turned[4], spring * rate(0.15) + (0.5 * mm - spring) * rate(0.3));
    EXPECT_EQ(turned[4].record.reversals, 4);
}

// Behind the origin to -2 mm, x = 1.6, ratio 0.22, back to -1.5 mm, all spring, and out again. Beyond, at -5
// mm, 0.3.
TEST_F(CyclicSecondCycle, InTheBackwardAdvance) {
    const auto turned = rows(granite(), {5, 0, -2, -1.5, -2, -5});
    expect_stress(turned[2], -tau(-0.38));
    expect_stress(turned[3], -tau(0.22));
    expect_opening(turned[2], turned[3], opening(-0.38, 0.1, 1.25 * mm) + opening(0.1, 0.22, 0.75 * mm));
    expect_stress(turned[4], -tau(0.22) + k * 0.5 * mm);
    EXPECT_EQ(turned[4].record.stage, JointStage::backward_unloading);
    expect_opening(turned[3], turned[4], -0.5 * mm * rate(0.22));
    expect_stress(turned[5], -tau(0.22));
    expect_opening(turned[4], turned[5], 0.5 * mm * rate(0.22));
    expect_stress(turned[6], -tau(0.3));
    expect_opening(turned[5], turned[6], opening(0.22, 0.3, 0.5 * mm) + 2.5 * mm * rate(0.3));
    EXPECT_EQ(turned[6].record.reversals, 3);
}

// Half a millimetre behind the origin, x = 0.4 and ratio -0.188, where the locked joint does not dilate, and
// back across it. At 0.5 mm it slides at 0.12, by more than 0.1 mm; that is the fourth reversal, and still
// the second cycle.
TEST_F(CyclicSecondCycle, AcrossTheOriginAndBack) {
    const double slip = 1 * mm - reversal_displacement(0.12, -0.188);
    ASSERT_GT(slip, 0.1 * mm);
    const auto turned = rows(granite(), {5, 0, -0.5, 0, 0.5});
    expect_stress(turned[3], -tau(-0.188));
    expect_opening(turned[2], turned[3], opening(-0.38, -0.188, 0.5 * mm));
    expect_stress(turned[4], -tau(-0.188) + k * 0.5 * mm);
    expect_opening(turned[3], turned[4], 0);
    expect_stress(turned[5], tau(0.12));
    const double met = first_met(-0.5, -tau(-0.188), 0, 0.24);
    expect_opening(turned[4], turned[5], opening(0.24 * met, 0.12, (0.5 - met) * mm));
    EXPECT_EQ(turned[5].record.cycle, 2);
    EXPECT_EQ(turned[5].record.reversals, 4);
}

// Behind the origin by more than the peak displacement, to -1.5 mm, x = 1.2 and ratio 0.14, and back across
// it: the third cycle, here with half the second's ratios, 0.06 at 0.5 mm,
// once the spring has met them.
TEST_F(CyclicSecondCycle, AcrossTheOriginIntoTheThird) {
    auto law = granite();
    law.further_cycle_factor = 0.5;
    const double locked = reversal_displacement(0.14, -0.3);
    ASSERT_LT(locked, 1.5 * mm);
    const auto turned = rows(law, {3, -1.5, 0, 0.5});
    expect_stress(turned[2], -tau(0.14));
    expect_stress(turned[3], tau(-0.3));
    expect_opening(turned[2], turned[3], -locked * rate(0.14) - (1.5 * mm - locked) * rate(0.3));
    EXPECT_EQ(turned[3].record.cycle, 3);
    expect_stress(turned[4], tau(0.06));
    const double met = first_met(0, tau(-0.3), 0, 0.12);
    expect_opening(turned[3], turned[4], opening(0.12 * met, 0.06, (0.5 - met) * mm));
}

// The table's 0.3 times 0.9 for each reversal, of which the first cycle had two: 0.243 at 5 mm. A tenth of a
// millimetre of slip back is the third, 0.2187: the bound goes up, and the joint waits for its spring there,
// closing at the rate of before. A tenth out again is the fourth, 0.19683.
TEST_F(CyclicSecondCycle, WornByReversals) {
    const double back = reversal_displacement(0.243, -0.243) + 0.1 * mm;
    const double out = reversal_displacement(0.2187, -0.2187) + 0.1 * mm;
    const auto turned = rows(wearing(), {5, 3, 5});
    expect_stress(turned[1], tau(0.243));
    expect_stress(turned[2], -tau(-0.2187));
    const double locked = back + (tau(-0.2187) - tau(-0.243)) / k;
    expect_opening(turned[1], turned[2], -locked * rate(0.243) - (2 * mm - locked) * rate(0.2187));
    EXPECT_EQ(turned[2].record.reversals, 3);
    expect_stress(turned[3], tau(0.19683));
    expect_opening(turned[2], turned[3], out * rate(0.2187) + (2 * mm - out) * rate(0.19683));
    EXPECT_EQ(turned[3].record.reversals, 4);
}

// Ten times back by 0.06 mm of slip and out again by as much: never 0.1 mm on end, so nothing wears, and at
// 0.3 both ways it closes.
TEST_F(CyclicSecondCycle, ToAndFroBySmallerThanMinSlip) {
    const double there = 5 - reversal_displacement(0.243, -0.243) / mm - 0.06;
    std::vector<double> path = {5};
    for (int n = 0; n < 10; ++n) path.insert(path.end(), {there, 5});
    path.push_back(7.5);
    const auto turned = rows(wearing(), path);
    for (std::size_t n = 1; n + 1 < turned.size(); ++n) {
        expect_stress(turned[n], n % 2 == 1 ? tau(0.243) : -tau(-0.243));
        expect_opening(turned[1], turned[n], n % 2 == 1 ? 0 : (there - 5) * mm * rate(0.243));
    }
    expect_stress(turned.back(), tau(0.243));
    EXPECT_EQ(turned.back().record.reversals, 2);
}

// Back by 0.06, 0.03 and 0.03 mm of slip, with spring alone between: it counts at 0.1 mm in all. The bound is
// then that of 0.2187, which the spring reaches on the 0.02 mm left.
TEST_F(CyclicSecondCycle, BackInPartsSmallerThanMinSlip) {
    const double there = 5 - reversal_displacement(0.243, -0.243) / mm - 0.06;
    const auto turned = rows(wearing(), {5, there, there + 0.4, there - 0.03, there + 0.4, there - 0.06});
    expect_stress(turned[4], -tau(-0.243));
    EXPECT_EQ(turned[4].record.reversals, 2) << "0.09 mm";
    EXPECT_EQ(turned[6].record.reversals, 3) << "0.12 mm";
    const double left = 0.02 * mm * k;
    ASSERT_GT(left, tau(-0.2187) - tau(-0.243));
    expect_stress(turned[6], -tau(-0.2187));
    const double waits = (tau(-0.2187) - tau(-0.243)) / k;
    expect_opening(turned[4], turned[6],
                   -(0.01 * mm + waits) * rate(0.243) - (0.02 * mm - waits) * rate(0.2187));
}

}  // namespace
}  // namespace rockslope::cyclic_second_cycle_test
