#include "blockgen/mesh/find_overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen::find_overlap_test {
namespace {

using Rings = std::vector<Ring>;

BlockMesh mesh_of(const std::vector<Rings>& blocks) {
    BlockMesh mesh;
    mesh.block_materials = {"rock"};
    for (const Rings& rings : blocks) {
        mesh.begin_block(0);
        for (const Ring& ring : rings) {
            std::vector<VertexIndex> indices;
            for (const Point& p : ring) {
                indices.push_back(mesh.vertices.size());
                mesh.vertices.push_back(p);
            }
            mesh.add_ring(indices, std::vector<EdgeMark>(ring.size()));
        }
    }
    return mesh;
}

Ring box(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// The same ring, turned about the origin and moved.
Ring placed(const Ring& ring, double angle, const Point& by) {
    Ring result;
    for (const Point& p : ring)
        result.push_back({by.x + p.x * std::cos(angle) - p.y * std::sin(angle),
                          by.y + p.x * std::sin(angle) + p.y * std::cos(angle)});
    return result;
}

/// The smallest depth of the overlap of two rings in several places and directions; zero for none, -1 where
/// it is found in some of them only.
double depth_of(const Ring& a, const Ring& b) {
    double depth = -2;
    for (const double angle : {0.0, 0.3, 1.9, 4.0}) {
        for (const Point by : {Point{0, 0}, Point{-30, 7}, Point{466000, 6691582}}) {
            const Ring one = placed(a, angle, by), other = placed(b, angle, by);
            for (const auto& blocks : {std::vector<Rings>{{one}, {other}}, {{other}, {one}}}) {
                const auto found = find_overlap(mesh_of(blocks));
                const double here = found ? found->depth : 0;
                if (depth != -2 && (here > 0) != (depth > 0)) return -1;
                depth = depth == -2 ? here : std::min(depth, here);
                if (found && !(found->first == 0 && found->second == 1)) return -1;
            }
        }
    }
    return depth;
}

TEST(FindOverlap, LetsBlocksTouch) {
    EXPECT_EQ(depth_of(box(0, 0, 2, 1), box(2, 0, 2, 1)), 0) << "side by side";
    EXPECT_EQ(depth_of(box(0, 0, 2, 1), box(1.3, 1, 2, 1)), 0) << "on each other";
    EXPECT_EQ(depth_of(box(0, 0, 2, 1), box(2, 1, 2, 1)), 0) << "in a corner";
    EXPECT_EQ(depth_of(box(0, 0, 2, 1), box(5, 5, 2, 1)), 0) << "apart";
    EXPECT_EQ(depth_of(box(0, 0, 2, 1), box(2 - 1e-5, 0, 2, 1)), 0) << "rounded coordinates";
    const Ring notched = {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    EXPECT_EQ(depth_of(notched, box(1, 1, 2, 2)), 0) << "in a notch";
    EXPECT_EQ(depth_of(notched, box(1.2, 1.5, 1, 1)), 0) << "loose in a notch";
}

TEST(FindOverlap, FindsBlocksInOneAnother) {
    EXPECT_NEAR(depth_of(box(0, 0, 2, 1), box(1.7, 0, 2, 1)), 0.3, 1e-5) << "0.3 m, the sides in line";
    EXPECT_NEAR(depth_of(box(0, 0, 2, 1), box(1.99, 0, 2, 1)), 0.01, 1e-5);
    EXPECT_GT(depth_of(box(0, 0, 2, 1), box(1.7, 0.4, 2, 1)), 0.1) << "corners in each other";
    EXPECT_GT(depth_of(box(0, 0, 4, 1), box(1.5, -1.5, 1, 4)), 0.3) << "a cross: no corner is inside";
    EXPECT_GT(depth_of(box(0, 0, 2, 1), box(0, 0, 2, 1)), 0.2) << "the same place";
    EXPECT_GT(depth_of(box(0, 0, 9, 9), box(4, 4, 1, 1)), 0.2) << "one whole in the other";
    EXPECT_GT(depth_of({{0, 0}, {3, 0}, {0, 3}}, {{1, 0.5}, {4, 0.5}, {4, 3.5}}), 0.1) << "triangles";
}

TEST(FindOverlap, LeavesABlockInAHoleAlone) {
    const Rings frame = {box(0, 0, 4, 4), {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
    EXPECT_FALSE(find_overlap(mesh_of({frame, {box(1, 1, 2, 2)}})));
    EXPECT_FALSE(find_overlap(mesh_of({{box(1.5, 1.5, 1, 1)}, frame})));
    const auto found = find_overlap(mesh_of({frame, {box(0.8, 1, 2, 2)}}));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->depth, 0.2, 0.11);
    EXPECT_TRUE(found->at.x >= 0.8 && found->at.x <= 1 && found->at.y > 1 && found->at.y < 3);
}

// One block of a wall of 900 is moved; some blocks are as long as the wall.
TEST(FindOverlap, FindsTheOneAmongMany) {
    std::vector<Rings> blocks = {{box(-1, -2, 32, 2)}, {box(-1, 30, 32, 1)}};
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 30; ++column) blocks.push_back({box(column, row, 1, 1)});
    EXPECT_FALSE(find_overlap(mesh_of(blocks)));
    blocks[500] = {placed(blocks[500][0], 0, {0.01, 0})};
    const auto found = find_overlap(mesh_of(blocks));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->first, 500);
    EXPECT_EQ(found->second, 501);
    EXPECT_NEAR(found->depth, 0.01, 1e-9);
}

}  // namespace
}  // namespace rockslope::blockgen::find_overlap_test
