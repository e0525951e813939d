#include "dda/contact/owner_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/base/indices.hpp"

namespace rockslope::owner_index_test {
namespace {

using Items = std::vector<dda::ContactIndex>;
using Owners = std::vector<dda::BlockIndex>;
using ItemsOfBlocks = dda::OwnerIndex<dda::BlockIndex, dda::ContactIndex>;

Items of(const ItemsOfBlocks& index, dda::BlockIndex owner) {
    const auto items = index.of(owner);
    return {items.begin(), items.end()};
}

TEST(OwnerIndex, ReturnsTheItemsOfAnOwnerInAscendingOrder) {
    const ItemsOfBlocks index(5, Owners{3, 0, 3, 4, 0, 3});
    EXPECT_EQ(of(index, 0), (Items{1, 4}));
    EXPECT_EQ(of(index, 1), Items{});
    EXPECT_EQ(of(index, 2), Items{});
    EXPECT_EQ(of(index, 3), (Items{0, 2, 5}));
    EXPECT_EQ(of(index, 4), Items{3});
}

TEST(OwnerIndex, MayBeEmpty) {
    const ItemsOfBlocks index(2, {});
    EXPECT_EQ(of(index, 0), Items{});
    EXPECT_EQ(of(index, 1), Items{});
}

}  // namespace
}  // namespace rockslope::owner_index_test
