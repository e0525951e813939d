#include "dda/solve/outer/gap_settling.hpp"

#include <gtest/gtest.h>

namespace rockslope::gap_settling_test {
namespace {

using dda::GapSettling;

constexpr double tolerance = 3;

TEST(GapSettling, FirstMinimaAndContractingOnesSettle) {
    GapSettling settling;
    for (const double change : {1e7, 4e6, 1e6, 2e5, 9e4}) EXPECT_FALSE(settling.fails(change, tolerance));
}

// Changes of the forces in a shaken gouge slope, in a step that ended without success after 140 iterations.
TEST(GapSettling, FailsWhereForcesChangeAsMuchAgain) {
    GapSettling settling;
    EXPECT_FALSE(settling.fails(1.3e6, tolerance));
    EXPECT_TRUE(settling.fails(7.2e6, tolerance));
}

TEST(GapSettling, LeavesSmallChangesToTheIteration) {
    GapSettling settling;
    for (const double change : {100., 90., 200., 2900.}) EXPECT_FALSE(settling.fails(change, tolerance));
    EXPECT_TRUE(settling.fails(3100, tolerance));
}

// Changes of the force in a wedge of a shaken slope of Voronoi cells, in a step that ended without success
// after 48 iterations.
TEST(GapSettling, FailsWhereSmallChangesHardlyContract) {
    GapSettling settling;
    for (const double change : {324.9, 31.0, 31.5, 30.9, 30.3})
        EXPECT_FALSE(settling.fails(change, tolerance));
    EXPECT_TRUE(settling.fails(29.75, tolerance));
    GapSettling contracting;
    for (const double change : {100., 60., 29., 28., 20., 15., 7., 6.})
        EXPECT_FALSE(contracting.fails(change, tolerance));
    GapSettling within;
    for (int k = 0; k < 10; ++k) EXPECT_FALSE(within.fails(0.9 * tolerance, tolerance)) << "settled";
}

}  // namespace
}  // namespace rockslope::gap_settling_test
