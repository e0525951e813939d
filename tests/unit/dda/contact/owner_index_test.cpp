#include "dda/contact/owner_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace rockslope;

namespace {

using Items = std::vector<int>;

Items of(const dda::OwnerIndex& index, int owner) {
    const auto items = index.of(owner);
    return {items.begin(), items.end()};
}

TEST(OwnerIndex, ReturnsTheItemsOfAnOwnerInAscendingOrder) {
    const dda::OwnerIndex index(5, Items{3, 0, 3, 4, 0, 3});
    EXPECT_EQ(of(index, 0), (Items{1, 4}));
    EXPECT_EQ(of(index, 1), Items{});
    EXPECT_EQ(of(index, 2), Items{});
    EXPECT_EQ(of(index, 3), (Items{0, 2, 5}));
    EXPECT_EQ(of(index, 4), Items{3});
}

TEST(OwnerIndex, MayBeEmpty) {
    const dda::OwnerIndex index(2, {});
    EXPECT_EQ(of(index, 0), Items{});
    EXPECT_EQ(of(index, 1), Items{});
}

}  // namespace
