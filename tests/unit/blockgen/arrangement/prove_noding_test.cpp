#include "blockgen/arrangement/prove_noding.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace rockslope::blockgen::prove_noding_test {
namespace {

using testing::HasSubstr;
using Segments = std::vector<SourceSegment>;

std::string refusal_of(const Segments& segments, const NodedEdges& noded) {
    try {
        prove_noding(segments, noded, walk_faces(noded));
    } catch (const std::logic_error& error) {
        return error.what();
    }
    return "proved";
}

/// Traces of three kinds of angles, and a box round them.
Segments random_segments(unsigned seed, std::size_t count, double length) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Segments segments;
    const std::vector<Point> box = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    for (std::size_t k = 0; k < 4; ++k) segments.push_back({box[k], box[(k + 1) % 4], 0});
    for (std::size_t k = 0; k < count; ++k) {
        const double angle = k % 3 == 0   ? 0.3
                             : k % 3 == 1 ? 1.7 + 0.01 * uniform(engine)
                                          : std::numbers::pi * uniform(engine);
        const Point a{20 * uniform(engine), 20 * uniform(engine)};
        const double l = length * (0.5 + uniform(engine));
        segments.push_back({a, {a.x + l * std::cos(angle), a.y + l * std::sin(angle)}, 1 + k});
    }
    return segments;
}

TEST(NodingProof, FindsTheSameFacesWhereNothingIsChanged) {
    const Segments segments = random_segments(1, 300, 4);
    const NodedEdges noded = node_joints(segments, 0x1p-20);
    const NodingProof proof = prove_noding(segments, noded, walk_faces(noded));
    EXPECT_EQ(proof.segments, 304u);
    EXPECT_EQ(proof.changed_nodes, 0u);
    EXPECT_EQ(proof.collapsed, 0u);
    EXPECT_GT(proof.faces_before, 100u);
    EXPECT_EQ(proof.faces_after, proof.faces_before);
    EXPECT_EQ(proof.equal_faces, proof.faces_before);
}

TEST(NodingProof, HoldsOnCoarseGridsWhereMuchIsChanged) {
    for (const double step : {0x1p-10, 0x1p-6, 0x1p-4, 0x1p-3, 0x1p-2})
        for (unsigned seed = 1; seed <= 6; ++seed) {
            const Segments segments = random_segments(seed, 200, 5);
            const NodedEdges noded = node_joints(segments, step);
            EXPECT_EQ(refusal_of(segments, noded), "proved") << step << ' ' << seed;
        }
}

TEST(NodingProof, HoldsFarFromTheOriginAndInLargeModels) {
    for (const double scale : {1.0, 1000.0}) {
        Segments segments = random_segments(4, 200, 5);
        for (SourceSegment& s : segments)
            for (Point* p : {&s.a, &s.b}) *p = {466000.3 + scale * p->x, 6691582.7 + scale * p->y};
        EXPECT_EQ(refusal_of(segments, node_joints(segments, 0x1p-20)), "proved") << scale;
    }
}

TEST(NodingProof, CountsWhatNodingJoinsAndMerges) {
    // A box, cut by a line that ends 1e-7 m short of its right side: one face before, two after, at one node.
    Segments segments = {{{0, 0}, {4, 0}, 0}, {{4, 0}, {4, 4}, 0}, {{4, 4}, {0, 4}, 0}, {{0, 4}, {0, 0}, 0}};
    segments.push_back({{0, 1}, {4 - 1e-7, 2}, 1});
    NodedEdges noded = node_joints(segments, 0x1p-20);
    NodingProof proof = prove_noding(segments, noded, walk_faces(noded));
    EXPECT_EQ(proof.faces_before, 1u);
    EXPECT_EQ(proof.faces_after, 2u);
    EXPECT_EQ(proof.equal_faces, 0u);
    EXPECT_EQ(proof.changed_nodes, 1u);
    EXPECT_NEAR(proof.first_change.x, 4, 1e-6);
    EXPECT_NEAR(proof.first_change.y, 2, 1e-6);

    // Three lines that miss a common point by 1e-7 m enclose a triangle, which becomes that point; and a
    // trace below a cell is nothing. Six faces after, of seven before.
    segments.resize(4);
    segments.push_back({{0, 1}, {4, 3}, 1});
    segments.push_back({{0, 3}, {4, 1}, 2});
    segments.push_back({{2 + 1e-7, 0}, {2 + 1e-7, 4}, 3});
    segments.push_back({{1, 0.25}, {1 + 1e-8, 0.25}, 4});
    noded = node_joints(segments, 0x1p-20);
    proof = prove_noding(segments, noded, walk_faces(noded));
    EXPECT_EQ(proof.faces_before, 7u);
    EXPECT_EQ(proof.faces_after, 6u);
    EXPECT_EQ(proof.collapsed, 1u);
    EXPECT_EQ(proof.changed_nodes, 1u);
    EXPECT_EQ(refusal_of(segments, noded), "proved");
}

/// A box with crossing lines and a short trace beside one of them, on a grid of a sixteenth.
struct Example {
    Segments segments = {{{0, 0}, {8, 0}, 0}, {{8, 0}, {8, 8}, 0},    {{8, 8}, {0, 8}, 0},
                         {{0, 8}, {0, 0}, 0}, {{0, 2}, {8, 3}, 1},    {{0, 7}, {8, 4}, 2},
                         {{3, 0}, {4, 8}, 3}, {{5, 5.5}, {6, 5.1}, 4}};
    NodedEdges noded = node_joints(segments, 0x1p-4);

    NodeIndex node_at(double x, double y) const {
        NodeIndex nearest = 0;
        double smallest = 1e9;
        for (const NodeIndex v : noded.vertices.indices()) {
            const Point p = noded.frame.position(noded.vertices[v]);
            if (const double d = std::hypot(p.x - x, p.y - y); d < smallest) smallest = d, nearest = v;
        }
        return nearest;
    }
};

TEST(NodingProof, FindsAPlantedError) {
    EXPECT_EQ(refusal_of(Example().segments, Example().noded), "proved");

    Example moved;  // a crossing that lies three cells off
    moved.noded.vertices[moved.node_at(3.3, 2.4)].y += 3;
    EXPECT_THAT(refusal_of(moved.segments, moved.noded), HasSubstr("has no course within"));

    Example believed = moved;  // though a larger snap is told
    believed.noded.largest_snap = 1;
    EXPECT_THAT(refusal_of(believed.segments, believed.noded),
                HasSubstr("no node joins the segments that meet"));

    Example nameless;  // an edge that has lost its source
    nameless.noded.sources[nameless.noded.sources.size() / 2].source = 0;
    EXPECT_THAT(refusal_of(nameless.segments, nameless.noded), HasSubstr("noding: "));

    Example turned;  // an edge whose direction is wrong
    for (EdgeSource& s : turned.noded.sources)
        if (s.source == 3) s.reversed = !s.reversed;
    EXPECT_THAT(refusal_of(turned.segments, turned.noded), HasSubstr("has no course within"));

    Example another;  // the noding of other segments
    another.segments[5].b.y += 0.5;
    EXPECT_THAT(refusal_of(another.segments, another.noded), HasSubstr("has no course within"));

    Example more;  // a segment that is not there
    more.segments.pop_back();
    EXPECT_THAT(refusal_of(more.segments, more.noded), HasSubstr("runs along no segment of its source 4"));
}

/// A network of edges with one source each.
NodedEdges network(const std::vector<GridPoint>& vertices,
                   const std::vector<std::pair<EdgeEnds, EdgeSource>>& edges) {
    NodedEdges noded;
    noded.frame = {{0, 0}, 1};
    noded.vertices.assign(vertices.begin(), vertices.end());
    for (const auto& [ends, source] : edges) {
        noded.edges.push_back(ends);
        noded.sources.push_back(source);
        noded.first_source.push_back(static_cast<std::int32_t>(noded.sources.size()));
    }
    return noded;
}

TEST(NodingProof, FindsACrossingThatWasMissed) {
    // Each of two crossing segments is one edge, and has its course.
    const Segments cross = {{{0, 0}, {8, 8}, 0}, {{0, 8}, {8, 0}, 1}};
    const NodedEdges noded =
        network({{0, 0}, {0, 8}, {8, 0}, {8, 8}}, {{{0, 3}, {0, false}}, {{1, 2}, {1, false}}});
    EXPECT_THAT(refusal_of(cross, noded), HasSubstr("no node joins the segments that meet at (4, 4)"));
}

TEST(NodingProof, FindsABendRoundATrace) {
    // A trace of its own lies above the long segment, whose course has a bend above the trace. All nodes are
    // within the snap that is told.
    const Segments segments = {{{0, 0}, {20, 0}, 0}, {{9, 2}, {11, 2}, 1}};
    NodedEdges noded = network({{0, 0}, {9, 2}, {10, 5}, {11, 2}, {20, 0}},
                               {{{0, 2}, {0, false}}, {{1, 3}, {1, false}}, {{2, 4}, {0, false}}});
    noded.largest_snap = 6;
    EXPECT_THAT(refusal_of(segments, noded), HasSubstr("a segment has a node without a point at (10, 5)"));
}

TEST(NodingProof, FindsATraceInAnotherFace) {
    // The nodes of a square lie where its corners are, and those of a trace too; but an edge of the square is
    // the other diagonal way round: the trace lies in another face.
    const Segments segments = {
        {{0, 0}, {8, 0}, 0}, {{8, 0}, {4, 2}, 1}, {{4, 2}, {0, 0}, 2}, {{4, 3}, {4, 5}, 3}};
    NodedEdges noded =
        network({{0, 0}, {4, 2}, {4, 3}, {4, 5}, {8, 0}},
                {{{0, 1}, {2, true}}, {{0, 4}, {0, false}}, {{1, 4}, {1, true}}, {{2, 3}, {3, false}}});
    EXPECT_EQ(refusal_of(segments, noded), "proved");
    // The trace's nodes are given to another place of the list, so that it ends in the triangle.
    Segments inside = segments;
    inside[3] = {{4, 0.9}, {4, 1.4}, 3};
    EXPECT_THAT(refusal_of(inside, noded), HasSubstr("noding: "));
}

TEST(NodingProof, FindsATraceOnTheOtherSideOfASegment) {
    // The short trace lies a cell above the line 2; noding puts it a cell below, and believes to have snapped
    // by two cells.
    Example example;
    const double cell = 0x1p-4;
    Segments beside = example.segments, across = example.segments;
    const auto on_line = [](double x, double off) { return Point{x, 7 - 3 * x / 8 + off}; };
    beside[7] = {on_line(5, 1.2 * cell), on_line(6, 1.2 * cell), 4};
    across[7] = {on_line(5, -1.2 * cell), on_line(6, -1.2 * cell), 4};
    EXPECT_EQ(refusal_of(beside, node_joints(beside, cell)), "proved");
    NodedEdges noded = node_joints(across, cell);
    noded.largest_snap = 3 * cell;
    EXPECT_THAT(refusal_of(beside, noded), HasSubstr("noding: "));
}

// Found by a fuzzer: a trace of a third of a micrometre begins on the edge of a section, and vanishes on a
// grid of an eighth of a metre.
TEST(NodingProof, NeedsNoNodeWhereATraceThatVanishesTouchesASegment) {
    Segments segments;
    const std::vector<Point> box = {{0, 0}, {4, 0}, {4, 2.5}, {2, 4}, {0, 4}};
    for (std::size_t k = 0; k < 5; ++k) segments.push_back({box[k], box[(k + 1) % 5], 0});
    segments.push_back({{0, 3.0000002}, {3e-7, 3}, 1});
    const NodedEdges noded = node_joints(segments, 0x1p-3);
    EXPECT_EQ(refusal_of(segments, noded), "proved");
    EXPECT_EQ(prove_noding(segments, noded, walk_faces(noded)).collapsed, 1u);
}

}  // namespace
}  // namespace rockslope::blockgen::prove_noding_test
