#include "blockgen/noding/node_joints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rockslope::blockgen::node_joints_test {
namespace {

constexpr double cell = 0x1p-20;

NodedEdges node(std::vector<SourceSegment> segments, double step = cell) {
    return node_joints(segments, step);
}

TEST(NodeJoints, ACrossingIsOneVertex) {
    const NodedEdges noded = node({{{0, 0}, {1, 1}, 0}, {{0, 1}, {1, 0}, 1}});
    EXPECT_EQ(noded.vertices.size(), 5u);
    EXPECT_EQ(noded.edges.size(), 4u);
    EXPECT_EQ(noded.largest_snap, 0);
}

// Ends are also rounded to the fine grid of the first round, which on a coarse grid lengthens a joint most.
TEST(NodeJoints, TheLargestSnapCountsAnEndThatMovesLessThanTheFinestUnit) {
    const double off = 2.24e-8;
    EXPECT_NEAR(node({{{0, 3}, {3, off}, 0}}, 1).largest_snap, off, 1e-15);
}

TEST(NodeJoints, AnEndWithinHalfACellCutsTheSegment) {
    for (const double gap : {-0.4, -1e-6, 0.0, 1e-6, 0.4})
        EXPECT_EQ(node({{{0, 0}, {2, 0}, 0}, {{1, gap * cell}, {1, 1}, 1}}).edges.size(), 3u) << gap;
    EXPECT_EQ(node({{{0, 0}, {2, 0}, 0}, {{1, 3 * cell}, {1, 1}, 1}}).edges.size(), 2u);
}

TEST(NodeJoints, OverlapsKeepAllTheirSources) {
    const NodedEdges noded = node({{{0, 0}, {3, 3}, 0}, {{4, 4}, {1, 1}, 1}, {{3, 3}, {1, 1}, 2}});
    ASSERT_EQ(noded.edges.size(), 3u);
    EXPECT_EQ(noded.sources_of(0).size(), 1u);
    ASSERT_EQ(noded.sources_of(1).size(), 3u);
    EXPECT_FALSE(noded.sources_of(1)[0].reversed);
    EXPECT_TRUE(noded.sources_of(1)[1].reversed);
    EXPECT_EQ(noded.sources_of(2).size(), 1u);
}

TEST(NodeJoints, EmptyInputAndPointsMakeNoEdge) {
    EXPECT_TRUE(node({}).edges.empty());
    EXPECT_TRUE(node({{{1, 1}, {1, 1}, 0}}).edges.empty());
    EXPECT_TRUE(node({{{1, 1}, {1 + 1e-9, 1}, 0}}).edges.empty());
}

TEST(NodeJoints, RejectsModelsTooLargeForTheGrid) {
    EXPECT_THROW(node({{{0, 0}, {1e7, 0}, 0}}), std::invalid_argument);
    EXPECT_THROW(node({{{1e10, 0}, {1e10 + 1, 0}, 0}}), std::invalid_argument);
    EXPECT_NO_THROW(node({{{6691582, 466000}, {6691583, 466000}, 0}}));
}

/// Expects the invariant of NodedEdges, by brute force over all pairs, in integers.
void expect_clean(const NodedEdges& noded) {
    const auto at = [&](NodeIndex v) { return noded.vertices[v]; };
    for (const EdgeIndex e : noded.edges.indices()) {
        const auto [a, b] = noded.edges[e];
        const GridPoint p = at(a), q = at(b);
        for (const NodeIndex v : noded.vertices.indices()) {
            if (v == a || v == b) continue;
            const GridPoint r = noded.vertices[v];
            const double length = std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
            const double along = (static_cast<double>(r.x - p.x) * static_cast<double>(q.x - p.x) +
                                  static_cast<double>(r.y - p.y) * static_cast<double>(q.y - p.y)) /
                                 length;
            if (along < 0 || along > length) continue;
            EXPECT_GE(std::abs(static_cast<double>(twice_area(p, q, r))) / length, 0.4999) << e << ' ' << v;
        }
        for (const EdgeIndex f : indices(e)) {
            const auto [c, d] = noded.edges[f];
            if (c == a || c == b || d == a || d == b) continue;
            const bool crosses = side_of(p, q, at(c)) * side_of(p, q, at(d)) < 0 &&
                                 side_of(at(c), at(d), p) * side_of(at(c), at(d), q) < 0;
            EXPECT_FALSE(crosses) << e << ' ' << f;
        }
    }
}

TEST(NodeJoints, ACoarseGridGivesProperlyNodedEdges) {
    // On a coarser grid, more snapped segments come near other vertices.
    for (const double step : {0x1p-10, 0x1p-5, 0x1p-4, 0x1p-3}) {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> coordinate(0, 4);
        for (int trial = 0; trial < 10; ++trial) {
            std::vector<SourceSegment> segments;
            for (int k = 0; k < 25; ++k) {
                const Point a{coordinate(random), coordinate(random)};
                segments.push_back({a, {coordinate(random), coordinate(random)}, k});
                if (k % 5 == 0)
                    segments.push_back({a, {a.x + 3, a.y + 0.3 * step}, 100 + k});  // nearly parallel bundles
            }
            const NodedEdges noded = node(segments, step);
            expect_clean(noded);
            EXPECT_TRUE(improperly_noded_edges(noded.vertices, noded.edges).empty());
        }
    }
}

TEST(NodeJoints, NodingAgainChangesNothing) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> coordinate(0, 4);
    std::vector<SourceSegment> segments;
    for (int k = 0; k < 60; ++k)
        segments.push_back(
            {{coordinate(random), coordinate(random)}, {coordinate(random), coordinate(random)}, k});
    const NodedEdges once = node(segments, 0x1p-12);
    std::vector<SourceSegment> again;
    for (const auto& [a, b] : once.edges)
        again.push_back({once.frame.position(once.vertices[a]), once.frame.position(once.vertices[b]), 0});
    const NodedEdges twice = node(again, 0x1p-12);
    EXPECT_EQ(once.vertices.size(), twice.vertices.size());
    EXPECT_EQ(once.edges.size(), twice.edges.size());
    EXPECT_EQ(twice.largest_snap, 0);
}

TEST(NodeJoints, OrderAndDirectionDoNotMatter) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(0, 4);
    std::vector<SourceSegment> segments;
    for (int k = 0; k < 60; ++k)
        segments.push_back(
            {{coordinate(random), coordinate(random)}, {coordinate(random), coordinate(random)}, k});
    const NodedEdges forward = node(segments, 0x1p-6);
    std::reverse(segments.begin(), segments.end());
    for (SourceSegment& s : segments) std::swap(s.a, s.b);
    const NodedEdges backward = node(segments, 0x1p-6);
    EXPECT_EQ(forward.vertices, backward.vertices);
    EXPECT_EQ(forward.edges, backward.edges);
}

TEST(ImproperlyNodedEdges, AreFound) {
    const std::vector<GridPoint> vertices = {{0, 0}, {10, 10}, {0, 10}, {10, 0}, {20, 20}};
    EXPECT_EQ(improperly_noded_edges(vertices, PerEdge<EdgeEnds>{{0, 1}, {2, 3}, {1, 4}}),
              (std::vector<EdgeIndex>{0, 1}));
}

}  // namespace
}  // namespace rockslope::blockgen::node_joints_test
