// Partial and irregular reversals of marble at 0.5 MPa, Tables 6 and 7 of Ma et al. (2017), by hand from Eqs.
// (57) to (64). Displacements in mm, x = d / 0.3; cyclic_reversals_test.cpp explains the letters.
// Its tables bend everywhere and its return is steeper than the advance, so that a partial reversal does not
// close.

#include <gtest/gtest.h>

#include "dda/joint/shear_test.hpp"
#include "support/cyclic_joints.hpp"
#include "support/cyclic_reference.hpp"

namespace rockslope::cyclic_marble_test {
namespace {

using dda::CyclicBartonBandis;
using dda::JointStage;
using dda::ShearTestRow;
using joint_tests::expect_opening;
using joint_tests::expect_stress;
using joint_tests::marble;

class CyclicMarbleReversals : public testing::Test, protected joint_tests::ReferenceJoint {
  protected:
    CyclicMarbleReversals() : ReferenceJoint(joint_tests::reference_marble()) {}
    const double k = shear_stiffness();  ///< Pa/m
    /// The turn at 6 mm in the first cycle, x = 20: from ratio 0.35 to the return's -0.45, m.
    const double turn_at_6 = reversal_displacement(0.35, -0.45);
    /// Opening of the second advance from the origin, where it returned at tau(-0.1), to a displacement (mm)
    /// up to 0.3 mm, m. The locked joint does not dilate.
    double second_advance_to(double displacement) const {
        double met = 0;
        for (int n = 0; n < 60; ++n) met = (tau(0.11 + 0.3 * met) - tau(-0.1)) / (k * mm);
        return opening(0.11 + 0.3 * met, 0.11 + 0.3 * displacement, (displacement - met) * mm);
    }
};

std::vector<ShearTestRow> rows(const CyclicBartonBandis& law, const std::vector<double>& path) {
    return joint_tests::sheared(law, 0.5e6, path);
}

// Out to 6 mm, back to 5 and out again: it closes at 0.35 as far as the spring goes, then at 0.45, and opens
// at the worn 0.35. At 7.5 mm, x = 25, the table has a twelfth less.
TEST_F(CyclicMarbleReversals, InTheReturn) {
    ASSERT_LT(turn_at_6, 1 * mm);
    const auto turned = rows(marble(), {6, 5, 6, 7.5});
    const double further = 0.35 * 55 / 60;
    expect_stress(turned[1], tau(0.35));
    expect_stress(turned[2], -tau(-0.45));
    expect_opening(turned[1], turned[2], -turn_at_6 * rate(0.35) - (1 * mm - turn_at_6) * rate(0.45));
    expect_stress(turned[3], tau(0.35));
    expect_opening(turned[2], turned[3], 1 * mm * rate(0.35));
    expect_stress(turned[4], tau(further));
    expect_opening(turned[3], turned[4], opening(0.35, further, 1.5 * mm));
    EXPECT_EQ(turned[4].record.reversals, 2);
}

// On to 1.8 mm, x = 6, where the return has -0.5, a tenth of a millimetre out and back, all spring and at the
// worn 0.35, and on over the bends at x = 4 and 2 to x = 1.
TEST_F(CyclicMarbleReversals, InTheReturnWhereItBends) {
    const auto turned = rows(marble(), {6, 5, 1.8, 1.9, 0.3});
    expect_stress(turned[3], -tau(-0.5));
    expect_opening(turned[2], turned[3], -2.6 * mm * rate(0.45) - opening(0.45, 0.5, 0.6 * mm));
    expect_stress(turned[4], -tau(-0.5) + k * 0.1 * mm);
    EXPECT_EQ(turned[4].record.stage, JointStage::forward_advance);
    expect_opening(turned[3], turned[4], 0.1 * mm * rate(0.35));
    expect_stress(turned[5], -tau(-0.1));
    expect_opening(turned[4], turned[5],
                   -0.1 * mm * rate(0.35) - opening(0.5, 0.55, 0.6 * mm) - opening(0.55, 0.3, 0.6 * mm) -
                       opening(0.3, 0.1, 0.3 * mm));
    EXPECT_EQ(turned[5].record.reversals, 1);
}

// Behind the origin to -0.15 mm, x = 0.5 and ratio 0.1, and back: within the spring to the origin, then
// sliding at the 0.35 that 6 mm have left, while the spring closes it at 0.1 on both sides.
TEST_F(CyclicMarbleReversals, AcrossTheOriginAndBack) {
    const double slip = 0.45 * mm - reversal_displacement(0.35, 0.1);
    ASSERT_GT(slip, 0.1 * mm);
    const auto turned = rows(marble(), {6, 0, -0.15, 0, 0.3});
    expect_stress(turned[2], -tau(0));
    expect_stress(turned[3], -tau(0.1));
    expect_opening(turned[2], turned[3], opening(0, 0.1, 0.15 * mm));
    expect_stress(turned[4], -tau(0.1) + k * 0.15 * mm);
    expect_opening(turned[3], turned[4], -0.15 * mm * rate(0.1));
    expect_stress(turned[5], tau(0.35));
    ASSERT_LT(slip, 0.195 * mm);
    expect_opening(turned[4], turned[5], -(0.3 * mm - slip) * rate(0.1) + slip * rate(0.35));
    EXPECT_EQ(turned[5].record.cycle, 1);
    EXPECT_EQ(turned[5].record.reversals, 2);
}

// Behind the origin at -6 mm, ratio 0.35, where the return has -0.4: back to -5, out again, and to -0.9 mm, x
// = 3, where it has -0.3.
TEST_F(CyclicMarbleReversals, BehindTheOrigin) {
    const double locked = reversal_displacement(0.35, -0.4);
    const auto turned = rows(marble(), {6, -6, -5, -6, -0.9});
    expect_stress(turned[2], -tau(0.35));
    expect_stress(turned[3], tau(-0.4));
    expect_opening(turned[2], turned[3], -locked * rate(0.35) - (1 * mm - locked) * rate(0.4));
    expect_stress(turned[4], -tau(0.35));
    expect_opening(turned[3], turned[4], 1 * mm * rate(0.35));
    expect_stress(turned[5], tau(-0.3));
    expect_opening(turned[4], turned[5],
                   -locked * rate(0.35) - (4.8 * mm - locked) * rate(0.4) - opening(0.4, 0.3, 0.3 * mm));
    EXPECT_EQ(turned[5].record.reversals, 4);
}

// Slip below min_slip in both directions does not wear the joint, but contracts it: 0.06 mm at 0.45 back, at
// 0.35 out.
TEST_F(CyclicMarbleReversals, SmallerThanMinSlip) {
    auto law = marble();
    law.reversal_factor = 0.9;
    const double there = 6 - turn_at_6 / mm - 0.06;
    std::vector<double> path = {6};
    for (int n = 0; n < 10; ++n) path.insert(path.end(), {there, 6});
    const auto turned = rows(law, path);
    for (std::size_t n = 3; n < turned.size(); n += 2) {
        expect_stress(turned[n - 1], -tau(-0.45));
        expect_stress(turned[n], tau(0.35));
        expect_opening(turned[n - 2], turned[n], -0.06 * mm * (rate(0.45) - rate(0.35)));
    }
    EXPECT_EQ(turned.back().record.reversals, 0);
}

/// From the origin at the second cycle's beginning on, row 0.
std::vector<ShearTestRow> second_cycle(const CyclicBartonBandis& law, const std::vector<double>& path) {
    std::vector<double> whole = {15, -15, 0};
    whole.insert(whole.end(), path.begin(), path.end());
    const auto all = rows(law, whole);
    return {all.begin() + 3, all.end()};
}

// The second cycle begins at ratio 0.11 and rises to 0.5 at 1.2 mm, x = 4. 0.2 mm back from there and out
// again are all spring: at 0.5 both ways. At 1.8 mm, x = 6, the table has 0.475.
TEST_F(CyclicMarbleReversals, OfTheSecondCycleWhereItRises) {
    const auto turned = second_cycle(marble(), {1.2, 1, 1.2, 1.8});
    expect_stress(turned[0], tau(-0.1));
    expect_stress(turned[1], tau(0.5));
    expect_opening(turned[0], turned[1],
                   second_advance_to(0.3) + opening(0.2, 0.25, 0.3 * mm) + opening(0.25, 0.5, 0.6 * mm));
    expect_stress(turned[2], tau(0.5) - k * 0.2 * mm);
    expect_opening(turned[1], turned[2], -0.2 * mm * rate(0.5));
    expect_stress(turned[3], tau(0.5));
    expect_opening(turned[2], turned[3], 0.2 * mm * rate(0.5));
    expect_stress(turned[4], tau(0.475));
    expect_opening(turned[3], turned[4], opening(0.5, 0.475, 0.6 * mm));
    EXPECT_EQ(turned[4].record.reversals, 2);
}

// At 3.6 mm, x = 12, ratio 0.45 - 0.1 / 3, back to 3 at the return's -0.35, and out again at the worn ratio.
// Then over the bends of the return to 0.15 mm, x = 0.5 and ratio -0.05.
TEST_F(CyclicMarbleReversals, OfTheSecondCycleInTheReturn) {
    const double worn = 0.45 - 0.1 / 3;
    const double locked = reversal_displacement(worn, -0.35);
    ASSERT_LT(locked, 0.5 * mm);
    const auto turned = second_cycle(marble(), {3.6, 3, 3.6, 0.15});
    expect_stress(turned[1], tau(worn));
    expect_stress(turned[2], -tau(-0.35));
    expect_opening(turned[1], turned[2], -locked * rate(worn) - (0.6 * mm - locked) * rate(0.35));
    expect_stress(turned[3], tau(worn));
    expect_opening(turned[2], turned[3], 0.6 * mm * rate(worn));
    EXPECT_EQ(turned[3].record.reversals, 4);
    expect_stress(turned[4], -tau(-0.05));
    expect_opening(turned[3], turned[4],
                   -locked * rate(worn) - (1.2 * mm - locked) * rate(0.35) - opening(0.35, 0.2, 1.2 * mm) -
                       opening(0.2, 0.1, 0.6 * mm) - 0.3 * mm * rate(0.1) - opening(0.1, 0.05, 0.15 * mm));
    EXPECT_EQ(turned[4].record.reversals, 5);
}

// On across the origin to -0.45 mm, x = 1.5: the backward advance has nothing up to x = 1, then 0.05. Back,
// at the return's -0.1, into the third cycle, which is like the second with nothing worn off: 0.25 at 0.6 mm.
TEST_F(CyclicMarbleReversals, OfTheSecondCycleAcrossTheOrigin) {
    const double locked = reversal_displacement(0.05, -0.1);
    ASSERT_LT(locked, 0.45 * mm);
    const auto turned = second_cycle(marble(), {3.6, 0, -0.45, 0, 0.6});
    expect_stress(turned[2], -tau(0));
    expect_stress(turned[3], -tau(0.05));
    expect_opening(turned[2], turned[3], opening(0, 0.05, 0.15 * mm));
    expect_stress(turned[4], tau(-0.1));
    expect_opening(turned[3], turned[4], -locked * rate(0.05) - (0.45 * mm - locked) * rate(0.1));
    EXPECT_EQ(turned[4].record.cycle, 3);
    expect_stress(turned[5], tau(0.25));
    expect_opening(turned[4], turned[5], second_advance_to(0.3) + opening(0.2, 0.25, 0.3 * mm));
}

}  // namespace
}  // namespace rockslope::cyclic_marble_test
