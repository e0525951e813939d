#include "blockgen/cut/cut_blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blockgen/mesh/block_file.hpp"
#include "common/base/input_error.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/small_blocks.hpp"

namespace rockslope::blockgen::cut_blocks_test {
namespace {

using testing::HasSubstr;

std::string error_of(const SlopeModel& model, const CutOptions& options = {}) {
    return rockslope::error_of([&] { cut_blocks(model, all_traces(model), options); });
}

TEST(CutBlocks, WithoutJointsTheDomainIsOneBlock) {
    const CutResult result = cut(rectangle(3, 2));
    EXPECT_EQ(result.mesh.block_count(), 1u);
    EXPECT_EQ(result.mesh.corners.size(), 4u);
    EXPECT_EQ(result.report.domain_area, 6);
    EXPECT_TRUE(result.report.area_proved);
    EXPECT_TRUE(result.report.verified);
}

TEST(CutBlocks, OneJointMakesTwoBlocksThatShareAMarkedEdge) {
    SlopeModel model = rectangle(1, 1);
    add_trace(model, {{-1, 0.5}, {2, 0.5}}, "bedding");
    const CutResult result = cut(model);
    ASSERT_EQ(result.mesh.block_count(), 2u);
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{0.5, 0.5}));
    EXPECT_EQ(result.report.interior_edges, 1u);
    EXPECT_EQ(result.mesh.joint_materials, (std::vector<std::string>{"bedding"}));
    EXPECT_EQ(std::count(result.mesh.edge_marks.begin(), result.mesh.edge_marks.end(), (EdgeMark{0, 0})), 2);
    EXPECT_NEAR(result.report.joints[0].retained, 1, 1e-9);
}

// On a grid of 1 m the upper side of a lens lies at most two cells off the straight line between its tips.
// That line would pass below the corner of the lower side, which must stay because two joints meet there.
TEST(CutBlocks, SimplificationInvertsNoBlock) {
    SlopeModel model = rectangle(20, 20);
    model.grid = 1;
    add_trace(model, {{0, 10}, {2, 10}}, "left");
    add_trace(model, {{18, 10}, {20, 10}}, "right");
    add_trace(model, {{2, 10}, {10, 11}}, "a");
    add_trace(model, {{10, 11}, {18, 10}}, "b");
    add_trace(model, {{2, 10}, {5, 12}, {15, 12}, {18, 10}}, "c");
    EXPECT_EQ(areas(cut(model).mesh), (std::vector<double>{18, 174, 208}));
}

TEST(CutBlocks, AGridOfAHundredByAHundredJoints) {
    SlopeModel model = rectangle(101, 101);
    for (int k = 1; k <= 100; ++k) {
        add_trace(model, {{k + 0.0, -1}, {k + 0.0, 102}});
        add_trace(model, {{-1, k + 0.0}, {102, k + 0.0}});
    }
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 10201u);
    EXPECT_EQ(result.report.sizes.smallest_area, 1);
    EXPECT_EQ(result.report.sizes.largest_area, 1);
    EXPECT_EQ(result.mesh.vertices.size(), 102u * 102u);
}

TEST(CutBlocks, InclinedSetsMakeParallelogramsWithoutRedundantVertices) {
    // Inclined lines pass through no grid point, so every crossing is snapped.
    SlopeModel model = rectangle(20, 20);
    for (int k = -30; k <= 60; ++k) {
        add_trace(model, {{-50 - 0.37 * k, -50 + 1.13 * k}, {70 - 0.37 * k, -50 + 1.13 * k + 120 * 0.31}});
        add_trace(model, {{-5 + 1.21 * k, -10}, {-5 + 1.21 * k - 8, 30}});
    }
    const CutResult result = cut(model);
    EXPECT_GT(result.mesh.block_count(), 250u);
    EXPECT_EQ(result.report.domain_area, 400);
    for (const BlockIndex b : result.mesh.blocks()) {
        EXPECT_EQ(result.mesh.ring_count(b), 1u);
        EXPECT_LE(result.mesh.ring(b, 0).size(), 6u);
    }
    EXPECT_LT(result.report.largest_snap, 4 * model.grid);
}

TEST(CutBlocks, JointsThroughOnePointMakeAFan) {
    // The point is not a grid point: rounding each joint separately would give several crossings.
    SlopeModel model = rectangle(2, 2);
    const Point centre{1.0 / 3 + 0.6, 0.7 + std::numbers::pi / 10};
    for (int k = 0; k < 100; ++k) {
        const double angle = std::numbers::pi * (k + 0.2) / 100;
        const Point u{4 * std::cos(angle), 4 * std::sin(angle)};
        add_trace(model, {{centre.x - u.x, centre.y - u.y}, {centre.x + u.x, centre.y + u.y}});
    }
    EXPECT_EQ(cut(model).mesh.block_count(), 200u);
}

TEST(CutBlocks, ALatticeOfTrianglesHasNoSlivers) {
    SlopeModel model = rectangle(10.2, 10.4);
    const Point origin{0.123456789, 0.2};
    const double height = std::sqrt(3) / 2;
    for (int k = -40; k <= 40; ++k)
        for (int turn = 0; turn < 3; ++turn) {
            const double angle = turn * std::numbers::pi / 3;
            const Point u{std::cos(angle), std::sin(angle)};
            const Point p{origin.x - k * height * u.y, origin.y + k * height * u.x};
            add_trace(model, {{p.x - 40 * u.x, p.y - 40 * u.y}, {p.x + 40 * u.x, p.y + 40 * u.y}});
        }
    const CutResult result = cut(model);
    // Blocks are triangles of side 1, or pieces at the boundary; a sliver by rounding would have at most 1e-6
    // m2.
    EXPECT_GT(result.report.sizes.smallest_area, 1e-4);
    EXPECT_NEAR(result.report.sizes.largest_area, height / 2, 1e-5);
    EXPECT_EQ(result.report.domain_area, result.report.sizes.area);
}

TEST(CutBlocks, ConcaveDomain) {
    SlopeModel model = rectangle(1, 1);
    model.outline = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};  // a U
    add_trace(model, {{-1, 2}, {4, 2}});
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 3u);
    EXPECT_EQ(result.report.domain_area, 7);
    EXPECT_NEAR(result.report.joints[0].retained, 2, 1e-9);
}

TEST(CutBlocks, HolesAndTunnelsAreFree) {
    const SlopeModel model = slope(R"(
[domain]
outline = [[0, 0], [10, 0], [10, 10], [0, 10]]
holes = [[[1, 1], [2, 1], [2, 2], [1, 2]]]
block_material = "rock"
[[tunnel]]
shape = "circle"
centre = [6, 6]
radius = 2
segments = 64
[[tunnel]]
shape = "horseshoe"
floor = [10, 1]
width = 2
height = 2
)");
    const CutResult result = cut(model);
    ASSERT_EQ(result.mesh.block_count(), 1u);
    EXPECT_EQ(result.report.holes, 2u);
    // 64-gon of radius 2; half the horseshoe, of 32 segments, lies within the domain.
    const double circle = 32 * 4 * std::sin(2 * std::numbers::pi / 64);
    const double horseshoe = 1 + 8 * std::sin(std::numbers::pi / 32);
    EXPECT_NEAR(result.report.domain_area, 100 - 1 - circle - horseshoe, 1e-4);
    EXPECT_EQ(result.report.interior_edges, 0u);
}

TEST(CutBlocks, OverlappingTunnelsCountOnce) {
    SlopeModel model = rectangle(10, 10);
    const auto square = [](double x, double y) {
        return Ring{{x, y}, {x + 2, y}, {x + 2, y + 2}, {x, y + 2}};
    };
    model.tunnels = {
        {"a", square(3, 3), {}}, {"b", square(4, 4), {}}, {"c", square(9, 9), {}}, {"d", square(20, 2), {}}};
    EXPECT_EQ(cut(model).report.domain_area, 100 - 7 - 1);
}

TEST(CutBlocks, DanglingEdgesAndBridgesArePruned) {
    SlopeModel model = rectangle(10, 10);
    add_trace(model, {{5, 0}, {5, 10}}, "wall");
    add_trace(model, {{5, 3}, {8, 4}, {9, 3}}, "antenna");
    add_trace(model, {{1, 1}, {2, 2}}, "loose");
    add_trace(model, {{7, 7}, {8, 7}, {8, 8}, {7, 8}, {7, 7}}, "island");
    add_trace(model, {{8, 7.5}, {10, 7.5}}, "bridge");
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 3u);
    EXPECT_EQ(result.report.islands, 1u);
    const auto& joints = result.report.joints;
    EXPECT_NEAR(joints[0].retained, 10, 1e-6);
    EXPECT_NEAR(joints[1].pruned, std::hypot(3, 1) + std::sqrt(2), 1e-5);
    EXPECT_EQ(joints[1].retained, 0);
    EXPECT_NEAR(joints[2].pruned, std::sqrt(2), 1e-5);
    EXPECT_NEAR(joints[3].retained, 4, 1e-6);
    EXPECT_NEAR(joints[4].pruned, 2, 1e-6);
    // A pruned joint leaves no vertex on the wall at which it ended.
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{1, 49, 50}));
    EXPECT_EQ(result.mesh.vertices.size(), 6u + 4u);
}

TEST(CutBlocks, EndsNearTheBoundaryAreJoinedToIt) {
    for (const double gap : {0.0, 1e-12, 1e-9, 1e-7, -1e-12, -1e-9, -1e-7}) {
        SlopeModel model = rectangle(1, 1);
        model.outline = {{0, 0}, {1, 0.1}, {0.9, 1.1}, {-0.1, 1}};
        add_trace(model, {{-0.05 + gap, 0.5}, {0.95 - gap, 0.6 - 0.1 * gap}});
        EXPECT_EQ(cut(model).mesh.block_count(), 2u) << gap;
    }
    SlopeModel model = rectangle(1, 1);
    add_trace(model, {{1e-4, 0.5}, {1, 0.5}});
    EXPECT_EQ(cut(model).mesh.block_count(), 1u);
}

TEST(CutBlocks, DuplicatesAndOverlapsMakeOneEdge) {
    SlopeModel model = rectangle(3, 3);
    const Point a{-1, 0.3}, b{4, 2.1};
    const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
    add_trace(model, {a, b}, "first");
    add_trace(model, {b, a}, "reversed");
    add_trace(model, {at(0.1), at(0.6)}, "part");
    add_trace(model, {at(0.4), at(0.97)}, "other part");
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 2u);
    EXPECT_EQ(result.report.interior_edges, 1u);
    const double length = std::hypot(3, 3 * 0.36);
    EXPECT_NEAR(result.report.joints[0].retained, length, 1e-5);
    EXPECT_EQ(result.report.joints[1].retained, 0);
    EXPECT_NEAR(result.report.joints[1].repeated, length, 1e-5);
    EXPECT_EQ(result.mesh.joints[0].set, "first");
}

TEST(CutBlocks, CollinearPiecesThatOnlyTogetherCross) {
    SlopeModel model = rectangle(3, 3);
    const Point a{-0.01, 0.3}, b{3.01, 2.1};
    const auto at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
    add_trace(model, {a, at(0.7)}, "left");
    add_trace(model, {at(0.3), b}, "right");
    EXPECT_EQ(cut(model).mesh.block_count(), 2u);
}

TEST(CutBlocks, JointsAlongTheBoundaryAndOutsideAreCounted) {
    SlopeModel model = rectangle(2, 1);
    add_trace(model, {{-1, 0}, {3, 0}}, "on the boundary");
    add_trace(model, {{5, 5}, {6, 6}}, "outside");
    add_trace(model, {{1, 0.5}, {1, 0.5}}, "point");
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 1u);
    EXPECT_NEAR(result.report.joints[0].on_boundary, 2, 1e-9);
    EXPECT_EQ(result.report.boundary_edges, 4u);
    EXPECT_EQ(result.report.joints[1].retained + result.report.joints[2].retained, 0);
}

TEST(CutBlocks, ATriangulatedIslandIsKeptOrRefused) {
    SlopeModel model = rectangle(10, 10);
    const Point p{4, 4}, q{6, 4}, r{5, 6}, middle{5, 4.7};
    for (const Point& corner : {p, q, r}) add_trace(model, {corner, middle});
    add_trace(model, {p, q, r, p});
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 4u);
    EXPECT_EQ(result.report.islands, 1u);
    EXPECT_EQ(result.mesh.ring_count(0), 2u);
    EXPECT_NEAR(areas(result.mesh).back(), 98, 1e-5);
    model.islands = IslandPolicy::error;
    EXPECT_THAT(error_of(model), HasSubstr("encloses others at (4, 4)"));
}

TEST(CutBlocks, AnIslandThatTouchesTheBoundaryInOnePoint) {
    SlopeModel model = rectangle(4, 4);
    add_trace(model, {{0, 0}, {2, 1}, {1, 2}, {0, 0}});
    const CutResult result = cut(model);
    ASSERT_EQ(result.mesh.block_count(), 2u);
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{1.5, 14.5}));
    EXPECT_EQ(result.report.holes, 1u);
}

TEST(CutBlocks, TheOrderOfJointsDoesNotMatter) {
    SlopeModel model = rectangle(10, 10);
    for (int k = 0; k < 40; ++k)
        add_trace(model, {{std::fmod(3.7 * k, 11), -1}, {std::fmod(5.3 * k + 2, 13), 12}});
    const BlockMesh forward = cut(model).mesh;
    std::reverse(model.traces.begin(), model.traces.end());
    for (Trace& trace : model.traces) std::reverse(trace.points.begin(), trace.points.end());
    const BlockMesh backward = cut(model).mesh;
    EXPECT_GT(forward.block_count(), 100u);
    EXPECT_EQ(forward.vertices, backward.vertices);
    EXPECT_EQ(forward.corners, backward.corners);
}

TEST(CutBlocks, RegionsSeparateBlocksOfDifferentMaterials) {
    const std::string text = R"(
[domain]
outline = [[0, 0], [10, 0], [10, 10], [0, 10]]
block_material = "rock"
[[region]]
name = "soil"
block_material = "soil"
joint_material = "contact"
polygon = [[-1, 8], [11, 8], [11, 12], [-1, 12]]
[[region]]
name = "same rock"
polygon = [[2, 2], [4, 2], [4, 4], [2, 4]]
)";
    const CutResult result = cut(slope(text));
    ASSERT_EQ(result.mesh.block_count(), 2u);
    EXPECT_EQ(result.mesh.block_materials, (std::vector<std::string>{"rock", "soil"}));
    EXPECT_EQ(areas(result.mesh), (std::vector<double>{20, 80}));
    EXPECT_EQ(std::count(result.mesh.edge_marks.begin(), result.mesh.edge_marks.end(),
                         (EdgeMark{0, EdgeMark::no_joint})),
              2);
    EXPECT_EQ(result.mesh.joint_materials, (std::vector<std::string>{"contact"}));

    std::string without = text;
    without.erase(without.find("joint_material = \"contact\"\n"), 27);
    EXPECT_THAT(error_of(slope(without)), HasSubstr("expected joint_material"));
}

TEST(CutBlocks, BlocksAreSelectedByPointPolygonAndSide) {
    SlopeModel model = rectangle(3, 3);
    for (int k = 1; k <= 2; ++k) {
        add_trace(model, {{k + 0.0, -1}, {k + 0.0, 4}});
        add_trace(model, {{-1, k + 0.0}, {4, k + 0.0}});
    }
    BlockSelector bottom, inner, above;
    bottom.side = "bottom";
    inner.at = Point{1.5, 1.5};
    inner.prescribed = true;
    inner.name = "core";
    above.inside = {{1.9, 1.9}, {3.1, 1.9}, {3.1, 3.1}, {1.9, 3.1}};
    model.selectors = {bottom, inner, above};
    model.measured_points = {{"crest", {2.5, 2.9}, {}}};
    model.bolts = {{"b", "cable", {0.5, 2.5}, {1.5, 2.5}, {}}};
    const BlockMesh mesh = cut(model).mesh;
    EXPECT_EQ(std::count(mesh.motion.begin(), mesh.motion.end(), BlockMotion::fixed), 4);
    EXPECT_EQ(std::count(mesh.motion.begin(), mesh.motion.end(), BlockMotion::prescribed), 1);
    EXPECT_EQ(mesh.motion[mesh.measured_points[0].block], BlockMotion::fixed);
    EXPECT_NE(mesh.bolts[0].first_block, mesh.bolts[0].second_block);

    model.selectors = {inner};
    model.selectors[0].at = Point{1.5, -0.1};
    EXPECT_EQ(cut(model).report.warnings.size(), 4u);  // the block is far off, and three sides are loose
    model.selectors[0].at = Point{1.5, -9};
    EXPECT_THAT(error_of(model), HasSubstr("no block contains the point (1.5, -9)"));
    model.selectors = {bottom, inner};
    model.selectors[1].at = Point{1.5, 0.5};
    EXPECT_THAT(error_of(model), HasSubstr("already fixed"));
    model.selectors.clear();
    model.measured_points[0].at = {3.5, 0};
    EXPECT_THAT(error_of(model), HasSubstr("no block contains measured point 'crest'"));
}

TEST(CutBlocks, TooManyBlocksArePredicted) {
    SlopeModel model = rectangle(101, 101);
    for (int k = 1; k <= 100; ++k) {
        add_trace(model, {{k + 0.0, -1}, {k + 0.0, 102}});
        add_trace(model, {{-1, k + 0.0}, {102, k + 0.0}});
    }
    CutOptions options;
    options.max_blocks = 2000;  // four times as many and 1000 are too few for about 101 x 101 blocks
    EXPECT_THAT(error_of(model, options),
                AllOf(HasSubstr("the joints make about 10"),
                      HasSubstr("at most 9000 (four times --max-blocks, 2000, and 1000 more)")));
    options.max_blocks = 10200;
    EXPECT_THAT(error_of(model, options),
                HasSubstr("the joints make 10201 blocks; expected at most 10200 (--max-blocks)"));
    options.max_blocks = 10201;
    EXPECT_EQ(error_of(model, options), "no error");
}

TEST(CutBlocks, TheNodingIsProvedUpToALimit) {
    // Four sides and two joints, one of them of two segments.
    SlopeModel model = rectangle(4, 4);
    add_trace(model, {{-1, 1}, {2, 1}, {5, 3}});
    add_trace(model, {{1, -1}, {1, 5}});
    CutOptions options{.verify = true, .most_proved = 7};
    const CutReport proved = cut_blocks(model, all_traces(model), options).report;
    ASSERT_TRUE(proved.noding);
    EXPECT_EQ(proved.noding->segments, 7u);
    EXPECT_EQ(proved.noding->faces_after, 4u);
    EXPECT_EQ(proved.noding->equal_faces, 4u);
    EXPECT_THAT(report_text(proved), HasSubstr("\"noding_proof\": {\n    \"segments\": 7"));
    EXPECT_THAT(report_tables(proved), HasSubstr("7 segments; 4 faces before, 4 after, 4 of them equal"));

    options.most_proved = 6;
    const CutReport unproved = cut_blocks(model, all_traces(model), options).report;
    EXPECT_TRUE(unproved.verified);
    EXPECT_FALSE(unproved.noding);
    EXPECT_THAT(unproved.warnings,
                testing::Contains(HasSubstr(
                    "--verify proved the noded edges, not the noding: there are 7 segments, more than 6")));
}

TEST(CutBlocks, FacesOutsideTheRockAreNoBlocks) {
    // Half of the box is rock: the lower left triangle of 20 x 20 squares has 20 x 21 / 2 = 210 blocks, 20 of
    // them triangles. The box has about twice as many faces, which counted against the limit before.
    SlopeModel model;
    model.outline = {{0, 0}, {20, 0}, {0, 20}};
    model.block_material = "rock";
    for (int k = 1; k < 20; ++k) {
        add_trace(model, {{k + 0.0, -1}, {k + 0.0, 21}});
        add_trace(model, {{-1, k + 0.0}, {21, k + 0.0}});
    }
    CutOptions options;
    options.max_blocks = 210;
    EXPECT_EQ(error_of(model, options), "no error");
    options.max_blocks = 209;
    EXPECT_THAT(error_of(model, options),
                HasSubstr("the joints make 210 blocks; expected at most 209 (--max-blocks)"));
}

TEST(CutBlocks, CoordinatesFarFromTheOriginKeepTheirDigits) {
    SlopeModel near = rectangle(30, 20);
    for (int k = 0; k < 12; ++k)
        add_trace(near, {{2.3 * k, -1}, {2.3 * k + 4, 21}}),
            add_trace(near, {{-1, 1.7 * k}, {31, 1.7 * k + 3}});
    SlopeModel far = near;
    const Point shift{466000, 6691582};
    for (Point& p : far.outline) p = {p.x + shift.x, p.y + shift.y};
    for (Trace& trace : far.traces)
        for (Point& p : trace.points) p = {p.x + shift.x, p.y + shift.y};
    const CutResult here = cut(near), there = cut(far);
    EXPECT_EQ(here.mesh.block_count(), there.mesh.block_count());
    EXPECT_EQ(here.report.domain_area, there.report.domain_area);
}

}  // namespace
}  // namespace rockslope::blockgen::cut_blocks_test
