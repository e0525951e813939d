#include "blockgen/input/closed_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/error_of.hpp"

namespace rockslope::blockgen::closed_lines_test {
namespace {

using testing::HasSubstr;

Ring square(double low, double high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}, {low, low}};
}

TEST(ClosedLines, JoinsLinesInAnyOrderAndDirection) {
    // A square of four lines, two of them backwards, its corners off by nanometres; beside it a closed one.
    const std::vector<Ring> rings = closed_lines({{{0, 0}, {4, 0}},
                                                  square(10, 12),
                                                  {{0, 3}, {0, 1e-9}},
                                                  {{4, 3 + 1e-9}, {4, 0}},
                                                  {{4, 3}, {2, 3.5}, {0, 3}}},
                                                 {"map"});
    ASSERT_EQ(rings.size(), 2u);
    EXPECT_EQ(rings[0], square(10, 12));
    EXPECT_EQ(rings[1].front(), rings[1].back());
    EXPECT_EQ(rings[1].size(), 6u);
    EXPECT_NEAR(std::abs(twice_signed_area(Ring(rings[1].begin(), rings[1].end() - 1))), 2 * (12 + 1), 1e-7);
}

TEST(ClosedLines, OpenAndBranchingLinesAreRefused) {
    EXPECT_THAT(error_of([] {
                    closed_lines({{{0, 0}, {4, 0}}, {{4, 0}, {4, 3}}}, {"map"});
                }),
                HasSubstr("map: a line is not closed: it ends at (4, 3), where no other ends"));
    EXPECT_THAT(
        error_of([] {
            closed_lines({{{0, 0}, {4, 0}}, {{4, 0}, {4, 3}}, {{4, 3}, {0, 0}}, {{4, 0}, {9, 9}}}, {"map"});
        }),
        HasSubstr("3 lines end at (4, 0)"));
}

TEST(ClosedLines, LinesInsideOthersAreInnerRings) {
    const auto polygons =
        nested_polygons({square(2, 3), square(20, 30), square(0, 10), square(4, 8), square(5, 6)});
    ASSERT_EQ(polygons.size(), 3u);
    EXPECT_EQ(polygons[0], (std::vector<Ring>{square(20, 30)}));
    EXPECT_EQ(polygons[1], (std::vector<Ring>{square(0, 10), square(2, 3), square(4, 8)}));
    EXPECT_EQ(polygons[2], (std::vector<Ring>{square(5, 6)}));
}

}  // namespace
}  // namespace rockslope::blockgen::closed_lines_test
