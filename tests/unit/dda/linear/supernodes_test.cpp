#include "dda/linear/supernodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "dda/linear/linear_solver.hpp"
#include "unit/dda/linear/random_systems.hpp"

using namespace rockslope;

namespace {

using dda::BlockPattern;
using dda::Supernode;
using dda::SupernodeTree;

SupernodeTree tree_of(const BlockPattern& pattern) {
    return dda::find_supernodes(pattern, dda::fill_reducing_order(pattern));
}

/// The places that each column of the factor reaches, by playing the elimination through.
std::vector<std::set<int>> fill(const BlockPattern& pattern, const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    std::vector<std::set<int>> reach(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
            const int a = place[i];
            const int b = place[static_cast<std::size_t>(pattern.columns[static_cast<std::size_t>(k)])];
            reach[static_cast<std::size_t>(std::min(a, b))].insert(std::max(a, b));
        }
    }
    for (auto& column : reach) {
        if (column.empty()) continue;
        reach[static_cast<std::size_t>(*column.begin())].insert(std::next(column.begin()), column.end());
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
                return BlockPattern::from_pairs(320, grid_graph(20, 15));  // and twenty blocks alone
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

TEST_P(TreesOfGraphs, HoldAllThatEliminationFills) {
    const SupernodeTree tree = tree_of(pattern());
    const auto reach = fill(pattern(), tree.order);
    for (const Supernode& node : tree.nodes) {
        std::set<int> held(node.rows.begin(), node.rows.end());
        EXPECT_EQ(held.size(), node.rows.size());
        for (int k = node.first; k < node.first + node.pivots; ++k) {
            for (const int row : reach[static_cast<std::size_t>(k)])
                EXPECT_TRUE(row < node.first + node.pivots || held.count(row))
                    << "column " << k << ", row " << row;
        }
        // and no row that no pivot reaches
        for (const int row : node.rows) {
            bool reached = false;
            for (int k = node.first; k < node.first + node.pivots; ++k)
                reached = reached || reach[static_cast<std::size_t>(k)].count(row) > 0;
            EXPECT_TRUE(reached) << row;
        }
    }
}

TEST_P(TreesOfGraphs, HandOnToAParentThatHasThoseRows) {
    const SupernodeTree tree = tree_of(pattern());
    for (const Supernode& node : tree.nodes) {
        ASSERT_EQ(node.parent < 0, node.rows.empty());
        if (node.parent < 0) continue;
        const Supernode& parent = tree.nodes[static_cast<std::size_t>(node.parent)];
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

TEST(FindSupernodes, MergesWhatIsCheaperTogether) {
    // A chain of blocks: apart, each is a front of one pivot and one row.
    std::vector<std::pair<int, int>> chain;
    for (int k = 0; k + 1 < 64; ++k) chain.emplace_back(k, k + 1);
    std::vector<int> order(64);
    std::iota(order.begin(), order.end(), 0);
    const SupernodeTree tree = dda::find_supernodes(BlockPattern::from_pairs(64, chain), order);
    EXPECT_LT(tree.nodes.size(), 40U);
    double together = 0;
    for (const Supernode& node : tree.nodes)
        together += dda::front_cost(node.pivots, static_cast<int>(node.rows.size()));
    EXPECT_LT(together, 63 * dda::front_cost(1, 1) + dda::front_cost(1, 0));
}

}  // namespace
