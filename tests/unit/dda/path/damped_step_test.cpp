#include "dda/path/damped_step.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/pressed_block.hpp"

namespace rockslope::damped_step_test {
namespace {

using namespace rockslope::dda;
using rockslope::pressed_block::PressedBlock;

/// The part of the way that a step takes from no displacement down to a displacement towards a plane some way
/// below.
double part_down(double gap, double displacement, double tolerance = 0) {
    PressedBlock block(0);
    block.contact.origin.normal = -gap * block.contact.normal_stiffness;
    PerRow<Vec6> moved(1, Vec6::Zero());
    std::vector<Vec6> target{Vec6::Zero()};
    target[0][1] = -displacement;
    const std::vector<double> length{1.0};
    const bool whole = DampedStep().take(block.step(), target, length, tolerance, moved, ThreadPool(1));
    EXPECT_EQ(whole, moved[RowIndex(0)] == target[0]);
    return moved[RowIndex(0)][1] / -displacement;
}

// The block is 100 N out of balance above the plane. In the plane it is out of balance by the contact's force
// of 1e6 N/m less 100 N: tenfold, at 1.1 mm.
TEST(DampedStep, IsFullWhereTheForcesGrowLittle) {
    EXPECT_EQ(part_down(1, 0.5), 1) << "does not reach the plane";
    EXPECT_EQ(part_down(0, 1e-4), 1) << "into balance";
    EXPECT_EQ(part_down(0, 1.09e-3), 1) << "less than tenfold";
}

TEST(DampedStep, IsHalvedUntilTheForcesGrowLittle) {
    EXPECT_EQ(part_down(0, 1.12e-3), 1.0 / 2);
    EXPECT_EQ(part_down(0.1, 1), 1.0 / 16) << "an eighth is 25 mm into the plane";
    EXPECT_EQ(part_down(0.1, 0.19), 1.0 / 2);
}

TEST(DampedStep, IsFullWhereTheForcesStayBelowTheTolerance) {
    EXPECT_EQ(part_down(0, 2e-3, 2000), 1);
    EXPECT_EQ(part_down(0, 2e-3, 1800), 1.0 / 2) << "2 mm give 1902 N";
}

TEST(DampedStep, IsASixtyFourthAtLeast) {
    EXPECT_EQ(part_down(0, 1), 1.0 / 64);
}

// A chip among two hundred blocks, a metre into the plane: the others go their whole way of a millimetre.
TEST(DampedStep, HoldsABlockThatIsThrown) {
    constexpr std::size_t others = 200;
    PressedBlock chip(0);
    for (std::size_t k = 0; k < others; ++k) {
        chip.base.stiffness.push_back(1e3 * Mat6::Identity());
        chip.base.load.push_back(Vec6::Zero());
    }
    chip.row_contacts.find(others + 1, chip.springs);
    PerRow<Vec6> moved(others + 1, Vec6::Zero());
    std::vector<Vec6> target(others + 1, Vec6::Zero());
    for (Vec6& each : target) each[1] = -1e-3;
    target[0][1] = -1;
    const std::vector<double> length(others + 1, 1.0);
    EXPECT_FALSE(DampedStep().take(chip.step(), target, length, 0, moved, ThreadPool(1)));
    EXPECT_EQ(moved[RowIndex(0)], Vec6::Zero());
    for (std::size_t k = 1; k <= others; ++k) EXPECT_EQ(moved[RowIndex(k)], target[k]);
}

// Where the chip is light and thrown, but balanced where it goes, it goes there.
TEST(DampedStep, LetsABlockGoFarWhereForcesDoNotGrow) {
    PressedBlock chip(0);
    chip.base.stiffness.push_back(1e3 * Mat6::Identity());
    chip.base.load.push_back(Vec6::Zero());
    chip.row_contacts.find(2, chip.springs);
    PerRow<Vec6> moved(2, Vec6::Zero());
    std::vector<Vec6> target(2, Vec6::Zero());
    target[0][1] = 0.5;  // up, away from the plane
    const std::vector<double> length{0.01, 10.0};
    EXPECT_TRUE(DampedStep().take(chip.step(), target, length, 0, moved, ThreadPool(1)));
    EXPECT_EQ(moved[RowIndex(0)], target[0]);
}

}  // namespace
}  // namespace rockslope::damped_step_test
