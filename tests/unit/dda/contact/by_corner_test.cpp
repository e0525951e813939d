#include "dda/contact/by_corner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using Things = std::vector<int>;

Things of(const dda::ByCorner& by_corner, int corner) {
    const auto things = by_corner.of(corner);
    return {things.begin(), things.end()};
}

TEST(ByCorner, TellsThingsOfACornerInTheirOrder) {
    const dda::ByCorner by_corner(5, Things{3, 0, 3, 4, 0, 3});
    EXPECT_EQ(of(by_corner, 0), (Things{1, 4}));
    EXPECT_EQ(of(by_corner, 1), Things{});
    EXPECT_EQ(of(by_corner, 2), Things{});
    EXPECT_EQ(of(by_corner, 3), (Things{0, 2, 5}));
    EXPECT_EQ(of(by_corner, 4), Things{3});
}

TEST(ByCorner, MayBeEmpty) {
    const dda::ByCorner by_corner(2, {});
    EXPECT_EQ(of(by_corner, 0), Things{});
    EXPECT_EQ(of(by_corner, 1), Things{});
}

}  // namespace
