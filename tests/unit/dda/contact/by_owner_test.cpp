#include "dda/contact/by_owner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using Things = std::vector<int>;

Things of(const dda::ByOwner& by_owner, int owner) {
    const auto things = by_owner.of(owner);
    return {things.begin(), things.end()};
}

TEST(ByOwner, TellsThingsOfAnOwnerInTheirOrder) {
    const dda::ByOwner by_owner(5, Things{3, 0, 3, 4, 0, 3});
    EXPECT_EQ(of(by_owner, 0), (Things{1, 4}));
    EXPECT_EQ(of(by_owner, 1), Things{});
    EXPECT_EQ(of(by_owner, 2), Things{});
    EXPECT_EQ(of(by_owner, 3), (Things{0, 2, 5}));
    EXPECT_EQ(of(by_owner, 4), Things{3});
}

TEST(ByOwner, MayBeEmpty) {
    const dda::ByOwner by_owner(2, {});
    EXPECT_EQ(of(by_owner, 0), Things{});
    EXPECT_EQ(of(by_owner, 1), Things{});
}

}  // namespace
