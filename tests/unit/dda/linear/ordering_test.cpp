#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "dda/linear/elimination_tree.hpp"
#include "dda/linear/linear_solver.hpp"
#include "unit/dda/linear/random_systems.hpp"

namespace rockslope::ordering_test {
namespace {

using dda::BlockPattern;

void expect_permutation(std::vector<int> order, int size) {
    std::vector<int> all(static_cast<std::size_t>(size));
    std::iota(all.begin(), all.end(), 0);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, all);
}

/// Number of entries of the factor below the diagonal when the nodes of a graph are eliminated in an order.
std::size_t fill(int size, const std::vector<std::pair<dda::RowIndex, dda::RowIndex>>& pairs,
                 const std::vector<int>& order) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<std::vector<char>> linked(n, std::vector<char>(n, 0));
    for (const auto& [i, j] : pairs) {
        linked[i][j] = linked[j][i] = 1;
    }
    std::vector<char> eliminated(n, 0);
    std::size_t entries = 0;
    for (const int next : order) {
        const auto k = static_cast<std::size_t>(next);
        eliminated[k] = 1;
        std::vector<std::size_t> neighbours;
        for (std::size_t j = 0; j < n; ++j) {
            if (linked[k][j] && !eliminated[j]) neighbours.push_back(j);
        }
        entries += neighbours.size();
        for (const std::size_t i : neighbours) {
            for (const std::size_t j : neighbours) linked[i][j] = i != j;
        }
    }
    return entries;
}

TEST(FillReducingOrder, IsAPermutation) {
    for (const int size : {1, 2, 3, 10})
        expect_permutation(dda::fill_reducing_order(BlockPattern::from_pairs(size, {})), size);
    expect_permutation(dda::fill_reducing_order(BlockPattern::from_pairs(400, grid_graph(20, 20))), 400);
    std::mt19937 engine(3);
    for (const int size : {2, 5, 50, 300}) {
        std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs;
        for (int k = 0; k < 3 * size; ++k) {
            const int i = static_cast<int>(engine() % static_cast<unsigned>(size));
            const int j = static_cast<int>(engine() % static_cast<unsigned>(size));
            if (i != j) pairs.emplace_back(i, j);
        }
        expect_permutation(dda::fill_reducing_order(BlockPattern::from_pairs(size, pairs)), size);
    }
}

// In the natural order a 40 x 40 grid fills 40 entries a node; nested dissection needs about 8 log2(40)/2. A
// bound of one half leaves room.
TEST(FillReducingOrder, HalvesTheFillOfAGrid) {
    const auto pairs = grid_graph(40, 40);
    std::vector<int> natural(1600);
    std::iota(natural.begin(), natural.end(), 0);
    const auto order = dda::fill_reducing_order(BlockPattern::from_pairs(1600, pairs));
    EXPECT_LT(2 * fill(1600, pairs, order), fill(1600, pairs, natural));
}

std::vector<std::pair<dda::RowIndex, dda::RowIndex>> shuffled_and_swapped(
    std::vector<std::pair<dda::RowIndex, dda::RowIndex>> pairs) {
    std::shuffle(pairs.begin(), pairs.end(), std::mt19937(11));
    for (std::size_t k = 0; k < pairs.size(); k += 2) std::swap(pairs[k].first, pairs[k].second);
    return pairs;
}

// Neither the orders computed before nor the sequence in which the contacts name the pairs matter. METIS
// draws random numbers for a graph of this size: a seed by the clock or numbers that go on from the order
// before give another order.
TEST(FillReducingOrder, DependsOnTheGraphAlone) {
    const auto pairs = grid_graph(30, 30);
    const auto order = dda::fill_reducing_order(BlockPattern::from_pairs(900, pairs));
    for (int size = 20; size < 40; ++size)
        dda::fill_reducing_order(
            BlockPattern::from_pairs(static_cast<std::size_t>(size) * 20, grid_graph(size, 20)));
    EXPECT_EQ(dda::fill_reducing_order(BlockPattern::from_pairs(900, shuffled_and_swapped(pairs))), order);
}

// A node of the elimination tree follows its last child, and all of its subtree precedes it without a gap.
TEST(FillReducingOrder, MakesEachSubtreeContiguous) {
    const auto pattern = BlockPattern::from_pairs(900, grid_graph(30, 30));
    const auto order = dda::fill_reducing_order(pattern);
    const std::vector<int> parent = dda::elimination_tree(pattern, dda::inverse_permutation(order));
    ASSERT_EQ(parent.size(), 900u);
    std::vector<int> first(900), size(900, 1);
    std::iota(first.begin(), first.end(), 0);
    int branches = 0;
    for (int k = 0; k < 900; ++k) {
        EXPECT_EQ(k - first[k] + 1, size[k]) << "subtree of " << k;
        if (parent[k] < 0) continue;
        ASSERT_GT(parent[k], k);
        branches += parent[k] != k + 1;
        first[parent[k]] = std::min(first[parent[k]], first[k]);
        size[parent[k]] += size[k];
    }
    EXPECT_GT(branches, 20) << "in a chain every order is a postorder";
}

}  // namespace
}  // namespace rockslope::ordering_test
