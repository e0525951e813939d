#include "common/base/index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace rockslope::index_test {
namespace {

using BlockIndex = Index<struct BlockKind>;
using RowIndex = Index<struct RowKind>;

template <class Container, class Key>
concept Subscripts = requires(Container container, Key key) {
    container[key];
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
    a == b;
}
|| requires(A a, B b) {
    a < b;
};

// An integer is an index of any kind, an index is none of another kind and no number but a subscript.
static_assert(std::is_convertible_v<int, BlockIndex> && std::is_convertible_v<std::size_t, BlockIndex>);
static_assert(!std::is_convertible_v<RowIndex, BlockIndex> && !std::is_constructible_v<BlockIndex, RowIndex>);
static_assert(!std::is_convertible_v<BlockIndex, int> && !std::is_convertible_v<BlockIndex, double>);
static_assert(!std::is_convertible_v<double, BlockIndex> && !std::is_assignable_v<BlockIndex&, RowIndex>);
static_assert(Comparable<BlockIndex, BlockIndex> && Comparable<BlockIndex, int>);
static_assert(!Comparable<BlockIndex, RowIndex>);
static_assert(sizeof(BlockIndex) == sizeof(std::int32_t) && std::is_trivially_copyable_v<BlockIndex>);

// A container of a kind is subscripted by that kind only, and taken for no container of another.
static_assert(Subscripts<IndexedVector<BlockIndex, double>, BlockIndex>);
static_assert(Subscripts<IndexedVector<BlockIndex, double>, int>);
static_assert(!Subscripts<IndexedVector<BlockIndex, double>, RowIndex>);
static_assert(!Subscripts<const IndexedVector<BlockIndex, double>, RowIndex>);
static_assert(Subscripts<IndexedSpan<BlockIndex, const double>, BlockIndex>);
static_assert(!Subscripts<IndexedSpan<BlockIndex, const double>, RowIndex>);
static_assert(!std::is_convertible_v<IndexedVector<RowIndex, double>, IndexedVector<BlockIndex, double>>);
static_assert(
    !std::is_convertible_v<IndexedVector<RowIndex, double>&, IndexedSpan<BlockIndex, const double>>);
static_assert(!std::is_convertible_v<IndexedSpan<RowIndex, double>, IndexedSpan<BlockIndex, const double>>);
static_assert(
    std::is_convertible_v<IndexedVector<BlockIndex, double>&, IndexedSpan<BlockIndex, const double>>);
static_assert(
    std::is_convertible_v<const IndexedVector<BlockIndex, double>&, IndexedSpan<BlockIndex, const double>>);
static_assert(std::is_convertible_v<std::vector<double>&, IndexedSpan<BlockIndex, const double>>);
static_assert(std::is_convertible_v<IndexedSpan<BlockIndex, double>, IndexedSpan<BlockIndex, const double>>);

// Containers of no kind take every index.
static_assert(Subscripts<std::vector<double>, BlockIndex> && Subscripts<std::span<double>, RowIndex>);
static_assert(Subscripts<std::array<double, 2>, BlockIndex>);

TEST(Index, CountsComparesAndSubscripts) {
    BlockIndex block;
    EXPECT_TRUE(block == 0);
    EXPECT_TRUE(++block == 1u);
    EXPECT_TRUE(block + 2 == BlockIndex(3));
    EXPECT_TRUE(block - BlockIndex(3) == -2);
    EXPECT_TRUE((block < 2 && block > BlockIndex(0) && block <= std::size_t{1} && -1 < block));
    EXPECT_TRUE(block.exists());
    EXPECT_FALSE(BlockIndex::none().exists());
    EXPECT_TRUE(BlockIndex::none() == -1);
    EXPECT_TRUE(std::max(block, BlockIndex(4)).value() == 4);

    const std::vector<double> plain = {1, 2};
    const std::array<double, 2> array = {3, 4};
    EXPECT_TRUE(plain[block] == 2);
    EXPECT_TRUE(array[block] == 4);
}

TEST(Index, VectorsAndSpansOfAKind) {
    IndexedVector<BlockIndex, double> masses = {1, 2, 4};
    double sum = 0;
    for (const BlockIndex block : masses.indices()) sum += masses[block];
    for (const BlockIndex block : indices(BlockIndex(1), BlockIndex(3))) masses[block] = 0;
    EXPECT_TRUE(sum == 7);
    const IndexedSpan<BlockIndex, const double> view = masses;
    EXPECT_TRUE(view[0] == 1);
    EXPECT_TRUE(view[BlockIndex(2)] == 0);
    EXPECT_TRUE(indices<BlockIndex>(5).size() == 5);
    const auto all = masses.indices();
    EXPECT_TRUE(std::count_if(all.begin(), all.end(), [&](BlockIndex b) { return masses[b] == 0; }) == 2);
}

}  // namespace
}  // namespace rockslope::index_test
