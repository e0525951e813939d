#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "dda/linear/linear_solver.hpp"
#include "unit/dda/linear/random_systems.hpp"

using namespace rockslope;

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

TEST(FillReducingOrder, IsReproducible) {
    const auto pattern = BlockPattern::from_pairs(900, grid_graph(30, 30));
    EXPECT_EQ(dda::fill_reducing_order(pattern), dda::fill_reducing_order(pattern));
}

}  // namespace
