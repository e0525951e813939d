#include "dda/linear/supernodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "dda/linear/linear_solver.hpp"
#include "unit/dda/linear/random_systems.hpp"

namespace rockslope::supernodes_test {
namespace {

using dda::BlockPattern;
using dda::Supernode;
using dda::SupernodeTree;

/// Rows of each column of the factor, found by performing the elimination symbolically.
std::vector<std::set<int>> fill(const BlockPattern& pattern, const std::vector<int>& order) {
    std::vector<int> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<int>(k);
    std::vector<std::set<int>> reach(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::uint32_t k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const int a = position[i];
            const int b = position[pattern.columns[k]];
            reach[std::min(a, b)].insert(std::max(a, b));
        }
    }
    for (auto& column : reach) {
        if (column.empty()) continue;
        reach[*column.begin()].insert(std::next(column.begin()), column.end());
    }
    return reach;
}

class TreesOfGraphs : public testing::TestWithParam<int> {
  protected:
    BlockPattern pattern() const {
        switch (GetParam()) {
            case 0:
                return BlockPattern::from_pairs(1, {});
            case 1:
                return BlockPattern::from_pairs(9, {});
            case 2:
                return BlockPattern::from_pairs(300, grid_graph(20, 15));
            case 3:
                return BlockPattern::from_pairs(320, grid_graph(20, 15));  // 20 isolated blocks
            default:
                return RandomSystem(GetParam(), 2 * GetParam(), 7).pattern;
        }
    }
};

TEST_P(TreesOfGraphs, EliminateEachBlockOnceChildrenFirst) {
    const SupernodeTree tree = tree_of(pattern());
    std::vector<int> order = tree.order;
    std::sort(order.begin(), order.end());
    std::vector<int> all(order.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
    EXPECT_EQ(static_cast<int>(order.size()), pattern().size);
    int next = 0;
    for (std::size_t s = 0; s < tree.nodes.size(); ++s) {
        EXPECT_EQ(tree.nodes[s].first, next);
        EXPECT_GE(tree.nodes[s].pivots, 1);
        next += tree.nodes[s].pivots;
        if (tree.nodes[s].parent >= 0) {
            EXPECT_GT(tree.nodes[s].parent, static_cast<int>(s));
        }
    }
    EXPECT_EQ(next, pattern().size);
}

TEST_P(TreesOfGraphs, ContainAllFill) {
    const SupernodeTree tree = tree_of(pattern());
    const auto reach = fill(pattern(), tree.order);
    for (const Supernode& node : tree.nodes) {
        std::set<int> rows(node.rows.begin(), node.rows.end());
        EXPECT_EQ(rows.size(), node.rows.size());
        for (int k = node.first; k < node.first + node.pivots; ++k) {
            for (const int row : reach[k])
                EXPECT_TRUE(row < node.first + node.pivots || rows.count(row))
                    << "column " << k << ", row " << row;
        }
        // no row that is in no pivot column
        for (const int row : node.rows) {
            bool reached = false;
            for (int k = node.first; k < node.first + node.pivots; ++k)
                reached = reached || reach[k].count(row) > 0;
            EXPECT_TRUE(reached) << row;
        }
    }
}

TEST_P(TreesOfGraphs, HaveParentsThatContainTheirRows) {
    const SupernodeTree tree = tree_of(pattern());
    for (const Supernode& node : tree.nodes) {
        ASSERT_EQ(node.parent < 0, node.rows.empty());
        if (node.parent < 0) continue;
        const Supernode& parent = tree.nodes[node.parent];
        for (const int row : node.rows) {
            EXPECT_GE(row, parent.first);
            EXPECT_TRUE(row < parent.first + parent.pivots ||
                        std::binary_search(parent.rows.begin(), parent.rows.end(), row));
        }
        EXPECT_LT(node.rows.front(), parent.first + parent.pivots);
    }
}
INSTANTIATE_TEST_SUITE_P(Graphs, TreesOfGraphs, testing::Values(0, 1, 2, 3, 10, 40, 150),
                         [](const auto& tested) { return "graph_" + std::to_string(tested.param); });

TEST(FindSupernodes, MergesWhereOneFrontIsCheaper) {
    // A chain of blocks. Without merging each block is a front of one pivot and one row.
    std::vector<std::pair<dda::RowIndex, dda::RowIndex>> chain;
    for (int k = 0; k + 1 < 64; ++k) chain.emplace_back(k, k + 1);
    std::vector<int> order(64);
    std::iota(order.begin(), order.end(), 0);
    const SupernodeTree tree = dda::find_supernodes(BlockPattern::from_pairs(64, chain), order);
    EXPECT_LT(tree.nodes.size(), 40U);
    double merged_cost = 0;
    for (const Supernode& node : tree.nodes)
        merged_cost += dda::front_cost(node.pivots, static_cast<int>(node.rows.size()));
    EXPECT_LT(merged_cost, 63 * dda::front_cost(1, 1) + dda::front_cost(1, 0));
}

}  // namespace
}  // namespace rockslope::supernodes_test
