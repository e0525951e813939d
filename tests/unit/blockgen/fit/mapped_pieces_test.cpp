#include "blockgen/fit/mapped_pieces.hpp"

#include <gtest/gtest.h>

namespace rockslope::blockgen::mapped_pieces_test {
namespace {

/// A square of 10 m with a hole of 2 m in its middle.
MapWindow square_with_hole() {
    return {{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}}};
}

std::vector<MappedPiece> pieces_of(const std::vector<Point>& points) {
    return mapped_pieces({{"t", "t", points}}, square_with_hole(), 1e-3);
}

TEST(MapWindow, HasTheAreaWithoutItsHoles) {
    EXPECT_EQ(square_with_hole().area(), 96);
}

TEST(MappedPieces, CountTheEndsThatAreSeen) {
    const auto whole = pieces_of({{1, 1}, {3, 1}});
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_DOUBLE_EQ(whole[0].length, 2);
    EXPECT_EQ(whole[0].ends, 2);
    const auto cut = pieces_of({{1, 1}, {13, 1}});
    ASSERT_EQ(cut.size(), 1u);
    EXPECT_DOUBLE_EQ(cut[0].length, 9);
    EXPECT_EQ(cut[0].ends, 1);
    const auto through = pieces_of({{-1, 2}, {13, 2}});
    ASSERT_EQ(through.size(), 1u);
    EXPECT_DOUBLE_EQ(through[0].length, 10);
    EXPECT_EQ(through[0].ends, 0);
}

TEST(MappedPieces, EndWhereTheMapDoesThoughDigitsMissIt) {
    EXPECT_EQ(pieces_of({{1, 1}, {9.9995, 1}})[0].ends, 1);
    EXPECT_EQ(pieces_of({{1, 1}, {9.99, 1}})[0].ends, 2);
}

TEST(MappedPieces, OfABentTraceAreOne) {
    const auto bent = pieces_of({{1, 1}, {3, 1}, {3, 3}});
    ASSERT_EQ(bent.size(), 1u);
    EXPECT_DOUBLE_EQ(bent[0].length, 4);
    EXPECT_EQ(bent[0].ends, 2);
    EXPECT_EQ(bent[0].b, (Point{3, 3}));
}

TEST(MappedPieces, AreCutByHolesAndByLeaving) {
    const auto across = pieces_of({{1, 5}, {9, 5}});
    ASSERT_EQ(across.size(), 2u);
    EXPECT_DOUBLE_EQ(across[0].length + across[1].length, 6);
    EXPECT_EQ(across[0].ends + across[1].ends, 2);
    const auto back = pieces_of({{8, 1}, {12, 1}, {12, 2}, {8, 2}});
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ(back[0].ends + back[1].ends, 2);
    EXPECT_TRUE(pieces_of({{11, 1}, {12, 1}}).empty());
    EXPECT_TRUE(pieces_of({{4.5, 5}, {5.5, 5}}).empty());
}

}  // namespace
}  // namespace rockslope::blockgen::mapped_pieces_test
