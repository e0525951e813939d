#include "blockgen/arrangement/arrange.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace rockslope::blockgen::walk_faces_test {
namespace {

/// Expects the same faces, up to their numbering.
void expect_same(const NodedEdges& noded) {
    const Subdivision swept = arrange(noded), walked = walk_faces(noded);
    ASSERT_EQ(swept.face_count, walked.face_count);
    EXPECT_EQ(swept.next, walked.next);
    std::map<FaceIndex, FaceIndex> number = {{0, 0}}, back = {{0, 0}};
    for (const HalfEdgeIndex h : swept.face.indices()) {
        const auto to = number.emplace(swept.face[h], walked.face[h]).first;
        const auto from = back.emplace(walked.face[h], swept.face[h]).first;
        ASSERT_EQ(to->second, walked.face[h]) << h;
        ASSERT_EQ(from->second, swept.face[h]) << h;
    }
    const ArrangementSummary exact = arrange_exactly(noded), ours = summarize(noded, walked);
    EXPECT_EQ(exact.twice_areas, ours.twice_areas);
    EXPECT_EQ(exact.adjacency, ours.adjacency);
}

void add_ring(std::vector<SourceSegment>& segments, const std::vector<Point>& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k)
        segments.push_back({ring[k], ring[(k + 1) % ring.size()], segments.size()});
}

TEST(WalkFaces, NestedComponents) {
    std::vector<SourceSegment> segments;
    for (int k = 0; k < 6; ++k) {
        const double r = 10 - 1.5 * k;
        add_ring(segments, {{-r, -r}, {r, -r}, {r, r}, {-r, r}});
    }
    // Components beside each other, above each other, with the same leftmost x; a single segment; a tree.
    add_ring(segments, {{20, 0}, {22, 0}, {21, 2}});
    add_ring(segments, {{20, 5}, {22, 5}, {21, 7}});
    segments.push_back({{20, 3}, {20, 4}, 90});
    segments.push_back({{20.5, 0.5}, {21, 0.6}, 91});
    segments.push_back({{21, 0.6}, {21.2, 0.5}, 92});
    segments.push_back({{-9.5, -9.2}, {-9, 9}, 93});
    expect_same(node_joints(segments, 0x1p-20));
}

TEST(WalkFaces, ComponentsThatTouchInAPointAreOne) {
    std::vector<SourceSegment> segments;
    add_ring(segments, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    add_ring(segments, {{0, 0}, {4, 2}, {2, 4}});
    add_ring(segments, {{2, 4}, {3, 6}, {1, 6}});
    expect_same(node_joints(segments, 0x1p-20));
}

TEST(WalkFaces, AgreesWithTheSweepOnRandomNetworks) {
    for (const double length : {0.3, 1.0, 8.0})
        for (unsigned seed = 1; seed <= 5; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> place(0, 10), reach(-length, length);
            std::vector<SourceSegment> segments;
            for (int k = 0; k < 400; ++k) {
                const Point a{place(random), place(random)};
                segments.push_back({a, {a.x + reach(random), a.y + reach(random)}, k});
                if (k % 7 == 0) segments.push_back({a, {a.x, a.y + reach(random)}, 1000 + k});
            }
            expect_same(node_joints(segments, seed % 2 == 0 ? 0x1p-20 : 0x1p-6));
        }
}

TEST(WalkFaces, EmptyNetworkHasOneFace) {
    EXPECT_EQ(walk_faces(node_joints({}, 1)).face_count, 1);
}

}  // namespace
}  // namespace rockslope::blockgen::walk_faces_test
