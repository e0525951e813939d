#include "blockgen/noding/link_chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rockslope::blockgen::link_chains_test {
namespace {

constexpr double cell = 0x1p-5;  // coarse, so that many edges come near other vertices

NodedEdges random_network(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(0, 16);
    std::vector<SourceSegment> segments;
    for (int k = 0; k < 80; ++k) {
        const Point a{coordinate(random), coordinate(random)}, b{coordinate(random), coordinate(random)};
        segments.push_back({a, {a.x + 0.3 * (b.x - a.x), a.y + 0.3 * (b.y - a.y)}, k});
    }
    return node_joints(segments, cell);
}

std::vector<GridPoint> places(const SnappedChains& chains, SegmentIndex k) {
    std::vector<GridPoint> result;
    for (const CellIndex c : chains.chain(k)) result.push_back(chains.cells[c]);
    return result;
}

/// Adds edges across a properly noded network, so that a round has edges to snap. @return flags of the added
/// edges.
PerEdge<char> add_random_edges(NodedEdges& network, unsigned seed) {
    std::mt19937 random(seed);
    PerEdge<char> changed(network.edges.size(), 0);
    const auto vertex = [&] { return NodeIndex(random() % static_cast<unsigned>(network.vertices.size())); };
    for (int k = 0; k < 6; ++k) {
        const auto [a, b] = std::minmax({vertex(), vertex()});
        if (a == b) continue;
        network.edges.emplace_back(a, b);
        changed.push_back(1);
    }
    return changed;
}

TEST(SnapRoundEdges, LocalRoundEqualsRoundOfAllEdges) {
    std::size_t bent = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        NodedEdges network = random_network(seed);
        EXPECT_TRUE(snap_round_edges(network.vertices, network.edges, {}).is_fully_noded()) << seed;
        const PerEdge<char> changed = add_random_edges(network, seed);
        const SnapRoundingPass all = snap_round_edges(network.vertices, network.edges, {});
        const SnapRoundingPass local = snap_round_edges(network.vertices, network.edges, changed);
        ASSERT_EQ(all.edges, local.edges) << seed;
        for (const SegmentIndex k : all.edges.indices()) {
            ASSERT_EQ(places(local.chains, k), places(all.chains, k)) << seed << ' ' << k;
            ASSERT_GT(all.chains.chain(k).size(), 2u) << seed << ' ' << k;
        }
        bent += all.edges.size();
    }
    EXPECT_GT(bent, 200u);
}

TEST(LinkChains, LocalRoundGivesTheNetworkOfARoundOfAllEdges) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        NodedEdges network = random_network(seed);
        const PerEdge<char> changed = add_random_edges(network, seed);
        LineSources along;
        for (const EdgeIndex e : network.edges.indices()) {
            along.sources.push_back({e.value(), false});
            along.first.push_back(e.value() + 1);
        }
        NodedEdges from_all, from_local;
        const auto chains = [&](EdgeSpan<const char> marks) {
            return chains_of_all_edges(snap_round_edges(network.vertices, network.edges, marks), network);
        };
        link_chains(chains({}), along, from_all);
        link_chains(chains(changed), along, from_local);
        EXPECT_EQ(from_all.vertices, from_local.vertices);
        EXPECT_EQ(from_all.edges, from_local.edges);
        EXPECT_EQ(from_all.sources, from_local.sources);
        EXPECT_EQ(from_all.first_source, from_local.first_source);
    }
}

TEST(LinkChains, EqualLinksBecomeOneEdgeAndCollapsedChainsAreDropped) {
    SnappedChains chains;
    chains.cells = {{0, 0}, {5, 0}, {9, 0}, {9, 9}};
    chains.items = {0, 1, 2, 2, 1, 3};
    chains.first = {0, 3, 5, 6};
    NodedEdges network;
    const PerEdge<char> changed =
        link_chains(chains, {{0, 1, 2, 3}, {{7, false}, {8, false}, {9, false}}}, network);
    EXPECT_EQ(network.vertices, (PerNode<GridPoint>{{0, 0}, {5, 0}, {9, 0}}));
    EXPECT_EQ(network.edges, (PerEdge<EdgeEnds>{{0, 1}, {1, 2}}));
    EXPECT_EQ(changed, (PerEdge<char>{1, 1}));
    ASSERT_EQ(network.sources_of(1).size(), 2u);
    EXPECT_EQ(network.sources_of(1)[0], (EdgeSource{7, false}));
    EXPECT_EQ(network.sources_of(1)[1], (EdgeSource{8, true}));
}

}  // namespace
}  // namespace rockslope::blockgen::link_chains_test
