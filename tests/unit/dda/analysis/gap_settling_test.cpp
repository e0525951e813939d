#include "dda/analysis/gap_settling.hpp"

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

}  // namespace
}  // namespace rockslope::gap_settling_test
