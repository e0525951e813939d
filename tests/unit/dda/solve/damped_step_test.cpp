#include "dda/solve/damped_step.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/pressed_block.hpp"

namespace rockslope::damped_step_test {
namespace {

using namespace rockslope::dda;
using rockslope::pressed_block::PressedBlock;

/// The length of the step from no displacement down by a displacement towards a plane some way below.
double length_down(double gap, double displacement, double tolerance = 0) {
    PressedBlock block(0);
    block.contact.origin.normal = -gap * block.contact.normal_stiffness;
    const std::vector<Vec6> from{Vec6::Zero()};
    std::vector<Vec6> target = from;
    target[0][1] = -displacement;
    const std::vector<double> length{1.0};
    return DampedStep().length(block.step(), from, target, length, tolerance, ThreadPool(1));
}

// The block is 100 N out of balance above the plane. In the plane it is out of balance by the contact's force
// of 1e6 N/m less 100 N: tenfold, at 1.1 mm.
TEST(DampedStep, IsFullWhereTheForcesGrowLittle) {
    EXPECT_EQ(length_down(1, 0.5), 1) << "does not reach the plane";
    EXPECT_EQ(length_down(0, 1e-4), 1) << "into balance";
    EXPECT_EQ(length_down(0, 1.09e-3), 1) << "less than tenfold";
}

TEST(DampedStep, IsHalvedUntilTheForcesGrowLittle) {
    EXPECT_EQ(length_down(0, 1.12e-3), 1.0 / 2);
    EXPECT_EQ(length_down(0.1, 1), 1.0 / 16) << "an eighth is 25 mm into the plane";
    EXPECT_EQ(length_down(0.1, 0.19), 1.0 / 2);
}

TEST(DampedStep, IsFullWhereTheForcesStayBelowTheTolerance) {
    EXPECT_EQ(length_down(0, 2e-3, 2000), 1);
    EXPECT_EQ(length_down(0, 2e-3, 1800), 1.0 / 2) << "2 mm give 1902 N";
}

TEST(DampedStep, IsASixtyFourthAtLeast) {
    EXPECT_EQ(length_down(0, 1), 1.0 / 64);
}

}  // namespace
}  // namespace rockslope::damped_step_test
