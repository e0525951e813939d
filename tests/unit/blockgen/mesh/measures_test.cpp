#include "blockgen/mesh/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockslope::blockgen::measures_test {
namespace {

/// One block with the given corners, rotated and far from the origin.
BlockMesh block(const Ring& corners) {
    BlockMesh mesh;
    mesh.begin_block(0);
    std::vector<VertexIndex> ring;
    for (const Point& p : corners) {
        ring.push_back(ring.size());
        mesh.vertices.push_back({466000 + 0.8 * p.x - 0.6 * p.y, 6691582 + 0.6 * p.x + 0.8 * p.y});
    }
    mesh.add_ring(ring, std::vector<EdgeMark>(corners.size()));
    return mesh;
}

TEST(Measures, RoundnessAndAspectOfKnownShapes) {
    const BlockMesh square = block({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    EXPECT_NEAR(block_roundness(square, 0), std::numbers::pi / 4, 1e-7);
    EXPECT_NEAR(block_aspect(square, 0), 1, 1e-7);
    const BlockMesh plank = block({{0, 0}, {5, 0}, {5, 1}, {0, 1}});
    EXPECT_NEAR(block_aspect(plank, 0), 0.2, 1e-7);
    EXPECT_NEAR(block_roundness(plank, 0), 4 * std::numbers::pi * 5 / 144, 1e-7);
    // Right triangle of unit sides, about its centroid: second moments of area 1/36, product moment -1/72.
    const BlockMesh triangle = block({{0, 0}, {1, 0}, {0, 1}});
    EXPECT_NEAR(block_aspect(triangle, 0), std::sqrt((1.0 / 36 - 1.0 / 72) / (1.0 / 36 + 1.0 / 72)), 1e-7);
}

TEST(Measures, ShapesOfAllBlocks) {
    EXPECT_EQ(shape_summary(BlockMesh{}).mean_corners, 0);
    BlockMesh mesh = block({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    const std::vector<VertexIndex> half = {0, 1, 2};
    mesh.begin_block(0);
    mesh.add_ring(half, std::vector<EdgeMark>(3));
    const ShapeSummary shapes = shape_summary(mesh);
    EXPECT_EQ(shapes.mean_corners, 3.5);
    EXPECT_NEAR(shapes.roundness.p90, std::numbers::pi / 4, 1e-7);
    EXPECT_LT(shapes.roundness.p10, shapes.roundness.p90);
    EXPECT_NEAR(shapes.aspect.p90, 1, 1e-7);
}

}  // namespace
}  // namespace rockslope::blockgen::measures_test
