#include "blockgen/mesh/check_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "blockgen/mesh/measures.hpp"
#include "common/base/input_error.hpp"
#include "common/geometry/orientation.hpp"
#include "support/error_of.hpp"

namespace rockslope::blockgen::check_mesh_test {
namespace {

using testing::HasSubstr;

BlockMesh mesh_of(const std::vector<Ring>& rings) {
    BlockMesh mesh;
    mesh.block_materials = {"rock"};
    mesh.begin_block(0);
    for (const Ring& ring : rings) {
        std::vector<VertexIndex> indices;
        for (const Point& p : ring) {
            indices.push_back(mesh.vertices.size());
            mesh.vertices.push_back(p);
        }
        mesh.add_ring(indices, std::vector<EdgeMark>(ring.size()));
    }
    return mesh;
}

std::string error_of(const BlockMesh& mesh) {
    return rockslope::error_of([&] { check_mesh(mesh, "slope.blocks"); });
}

const Ring square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ring hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};

TEST(CheckMesh, AcceptsABlockWithAHole) {
    EXPECT_EQ(error_of(mesh_of({square, hole})), "no error");
    // A hole that touches the outer ring in one corner leaves the block connected.
    EXPECT_EQ(error_of(mesh_of({square, {{0, 0}, {1, 2}, {2, 1}}})), "no error");
}

TEST(CheckMesh, RefusesBadRings) {
    EXPECT_THAT(error_of(mesh_of({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}})), HasSubstr("clockwise"));
    EXPECT_THAT(error_of(mesh_of({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}})), HasSubstr("meet at (2, 2)"));
    EXPECT_THAT(error_of(mesh_of({{{0, 0}, {4, 0}, {8, 0}}})), HasSubstr("meet at"));
    EXPECT_THAT(error_of(mesh_of({{{0, 0}, {4, 0}, {4, 0}, {4, 4}}})), HasSubstr("meet at (4, 0)"));
    EXPECT_THAT(error_of(mesh_of({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}})), HasSubstr("meet at (2, 0)"));
    EXPECT_THAT(error_of(mesh_of({square, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}})),
                HasSubstr("counter-clockwise"));
    EXPECT_THAT(error_of(mesh_of({square, {{5, 1}, {5, 2}, {6, 2}, {6, 1}}})),
                HasSubstr("outside the outer ring"));
    EXPECT_THAT(error_of(mesh_of({square, {{3, 1}, {3, 2}, {6, 2}, {6, 1}}})), HasSubstr("ring 0 and edge"));
    EXPECT_THAT(error_of(mesh_of({square, hole, {{1.2, 1.2}, {1.2, 1.8}, {1.8, 1.8}}})),
                HasSubstr("another hole"));
}

TEST(CheckMesh, RefusesBadIndicesAndPoints) {
    BlockMesh mesh = mesh_of({square, hole});
    mesh.measured_points = {{"crest", 0, {3, 3}}};
    EXPECT_EQ(error_of(mesh), "no error");
    mesh.measured_points[0].position = {1.5, 1.5};
    EXPECT_THAT(error_of(mesh), HasSubstr("'crest' at (1.5, 1.5) lies outside its block 0"));
    mesh.measured_points = {{"crest", 1, {3, 3}}};
    EXPECT_THAT(error_of(mesh), HasSubstr("has a block out of range"));
    mesh = mesh_of({square});
    mesh.corners[1] = 4;
    EXPECT_THAT(error_of(mesh), HasSubstr("vertex out of range"));
    mesh = mesh_of({square});
    mesh.edge_marks[1] = {0, 0};
    EXPECT_THAT(error_of(mesh), HasSubstr("edge mark out of range"));
    mesh = mesh_of({square});
    mesh.vertices[2].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(error_of(mesh), HasSubstr("not finite"));
}

TEST(CheckMesh, RefusesBoltsWithoutLengthAndSharedNames) {
    BlockMesh mesh = mesh_of({square});
    mesh.bolts = {{"anchor", "cable", 0, 0, {3, 3}, {3, 2}}};
    mesh.measured_points = {{"crest", 0, {3, 3}}, {"toe", 0, {3, 3}}};
    EXPECT_EQ(error_of(mesh), "no error");
    mesh.bolts[0].second = mesh.bolts[0].first;
    EXPECT_THAT(error_of(mesh), HasSubstr("bolt 'anchor' has no length"));
    mesh.bolts.clear();
    mesh.measured_points[1].name = "crest";
    EXPECT_THAT(error_of(mesh), HasSubstr("two measured points 'crest'"));
}

TEST(Orientation, IsExactWhereTheFilterFails) {
    // Three points that double arithmetic calls collinear, or worse, near a line of slope one (Kettner et al.
    // 2008).
    const double u = std::numeric_limits<double>::epsilon() / 2;
    const Point q{12, 12}, r{24, 24};
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 32; ++j)
            EXPECT_EQ(orientation({0.5 + i * u, 0.5 + j * u}, q, r), (i < j) - (i > j)) << i << ' ' << j;
}

TEST(Measures, OfASquareWithAHole) {
    const BlockMesh mesh = mesh_of({square, hole});
    EXPECT_DOUBLE_EQ(block_area(mesh, 0), 15);
    EXPECT_DOUBLE_EQ(block_perimeter(mesh, 0), 20);
    // First moment of the square minus that of the hole: (16 * 2 - 1 * 1.5) / 15.
    EXPECT_NEAR(block_centroid(mesh, 0).x, 30.5 / 15, 1e-14);
    const CornerSummary corners = corner_summary(mesh);
    EXPECT_DOUBLE_EQ(corners.smallest_edge, 1);
    EXPECT_NEAR(corners.smallest_angle, std::numbers::pi / 2, 1e-14);
    EXPECT_DOUBLE_EQ(area_summary(block_areas(mesh)).d50, 15);
}

TEST(Measures, FarFromTheOriginKeepTheirDigits) {
    Ring far = square;
    for (Point& p : far) p = {p.x + 466000, p.y + 6691582};
    const BlockMesh mesh = mesh_of({far});
    EXPECT_DOUBLE_EQ(block_area(mesh, 0), 16);
    EXPECT_DOUBLE_EQ(block_centroid(mesh, 0).y, 6691584);
}

}  // namespace
}  // namespace rockslope::blockgen::check_mesh_test
