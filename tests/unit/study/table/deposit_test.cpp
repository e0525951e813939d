#include "study/table/deposit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_of.hpp"

namespace rockslope::deposit_test {
namespace {

using namespace study;
using ::testing::ElementsAre;

Ring box(double left, double bottom, double width, double height) {
    return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

/// Ground at y = 0 from 0 to 20 m. A block of 2 m x 3 m and one of 4 m x 1 m stand side by side at its left;
/// the first comes to rest flat at 10 m, the other slides by 0.5 m.
RunOutlines moved_boxes() {
    RunOutlines outlines;
    outlines.start = {box(0, -1, 20, 1), box(0, 0, 2, 3), box(2, 0, 4, 1)};
    outlines.end = {{box(0, -1, 20, 1), 0}, {box(10, 0, 3, 2), 10}, {box(2.5, 0, 4, 1), 0.5}};
    return outlines;
}

TEST(Deposit, IsTheSurfaceOverThatAtTheStart) {
    const Deposit deposit(moved_boxes());
    EXPECT_EQ(deposit.surface(11), 2);
    EXPECT_EQ(deposit.height(11), 2) << "a deposit";
    EXPECT_EQ(deposit.height(1), -3) << "a scar";
    EXPECT_EQ(deposit.height(4), 0);
    EXPECT_EQ(deposit.height(6.25), 1);
    EXPECT_NEAR(*deposit.largest_height(3), 2, 1e-12) << "as wide as the block";
    EXPECT_NEAR(*deposit.largest_height(6), 1, 1e-12) << "twice as wide";
    EXPECT_FALSE(deposit.largest_height(21)) << "wider than the section";
    EXPECT_FALSE(deposit.surface(21));
    EXPECT_FALSE(deposit.height(-1));
}

TEST(Deposit, HasTheThicknessOfTheBlocksThatMoved) {
    const Deposit deposit(moved_boxes());
    EXPECT_EQ(deposit.thickness(4, 0.1), 1);
    EXPECT_EQ(deposit.thickness(4, 1), 0) << "moved by less";
    EXPECT_EQ(deposit.thickness(11, 1), 2);
    EXPECT_EQ(deposit.largest_thickness(0.1), 2);
    EXPECT_EQ(deposit.largest_thickness(20), 0);
}

// A wedge that lies on a slope of 1 : 2. Its thickness grows from nothing to 3 m at x = 4; the height over
// the slope is the same, the surface is y = x at the wedge's upper face.
TEST(Deposit, FindsTheLargestBetweenTheStations) {
    RunOutlines outlines;
    const Ring slope = {{0, -5}, {10, -5}, {10, 5}, {0, 0}};
    outlines.start = {slope, box(8.5, 4.5, 1, 1)};
    outlines.end = {{slope, 0}, {{{0, 0}, {4, 2}, {4, 5}}, 6}};
    const Deposit deposit(outlines);
    EXPECT_NEAR(deposit.thickness(2, 1), 0.25 * 3 * 2, 1e-12);
    EXPECT_NEAR(deposit.largest_thickness(1), 3, 1e-12);
    EXPECT_NEAR(*deposit.largest_height(1), 3 - 0.75 / 2, 1e-12) << "mean over the last metre";
    EXPECT_NEAR(*deposit.largest_height(1e-6), 3, 1e-5);
    EXPECT_NEAR(*deposit.height(3), 0.75 * 3, 1e-12);
    EXPECT_NEAR(*deposit.height(9), 4.5 - 5.5, 1e-12);
}

// The trapezoidal rule over the profile gives the volume that moved: the boxes begin and end at stations,
// where the larger side counts, so that each end adds half a cell.
TEST(Deposit, AProfileHasARowForEachMultipleOfTheInterval) {
    const TextTable table = Deposit(moved_boxes()).profile(0.1, 1);
    EXPECT_THAT(table.heading, ElementsAre("x (m)", "surface at the start (m)", "surface (m)",
                                           "height over the start (m)", "thickness of moved rock (m)"));
    ASSERT_EQ(table.rows.size(), 201u);
    EXPECT_THAT(table.rows[3], ElementsAre("0.3", "3", "0", "-3", "0"));
    EXPECT_THAT(table.rows[105], ElementsAre("10.5", "0", "2", "2", "2"));
    double volume = 0;
    for (const auto& row : table.rows) volume += 0.1 * std::stod(row[4]);
    EXPECT_NEAR(volume, 6 + 0.1 * 2, 1e-9);
    EXPECT_THAT(error_of([] { Deposit(moved_boxes()).profile(1e-6, 1); }),
                ::testing::HasSubstr("more than a million stations"));
}

TEST(Deposit, LeavesEmptyWhereThereIsNoRock) {
    RunOutlines outlines;
    outlines.start = {box(0, 0, 2, 1)};
    outlines.end = {{box(3, 0, 2, 1), 3}};
    const TextTable table = Deposit(outlines).profile(0.5, 1);
    EXPECT_THAT(table.rows[1], ElementsAre("0.5", "1", "", "", "0"));
    EXPECT_THAT(table.rows[8], ElementsAre("4", "", "1", "", "1"));
    EXPECT_EQ(Deposit(outlines).largest_height(1), 0) << "at no x at both times";
    EXPECT_FALSE(Deposit({}).largest_height(1));
    EXPECT_TRUE(Deposit({}).profile(1, 1).rows.empty());
}

// The face of a block that has moved by a millimetre is no deposit of its height.
TEST(Deposit, ASteepFaceThatMovesByALittleIsNone) {
    RunOutlines outlines;
    outlines.start = {box(0, -1, 20, 1), box(0, 0, 2, 30)};
    outlines.end = {{box(0, -1, 20, 1), 0}, {box(0.001, 0, 2, 30), 0.001}};
    EXPECT_NEAR(*Deposit(outlines).largest_height(1), 30 * 0.001, 1e-12);
}

TEST(Deposit, RefusesFoldersThatAreNoRun) {
    EXPECT_THAT(error_of([] { read_outlines(::testing::TempDir() + "/no-such-run"); }),
                ::testing::HasSubstr("contains no NAME.vtkhdf"));
}

}  // namespace
}  // namespace rockslope::deposit_test
