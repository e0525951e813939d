// Degenerate inputs, each with the expected blocks counted by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/base/input_error.hpp"
#include "support/error_of.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::degenerate_geometry_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Point moved(const Point& p, const Point& direction, double distance) {
    return {p.x + distance * direction.x, p.y + distance * direction.y};
}

/// Lines at 0, 60 and 120 degrees that cut the plane into triangles of side 1, with corners at `origin`.
void add_triangle_lattice(SlopeModel& model, const Point& origin, int lines, double reach) {
    const double height = std::sqrt(3) / 2;
    for (int turn = 0; turn < 3; ++turn) {
        const Point u{std::cos(turn * std::numbers::pi / 3), std::sin(turn * std::numbers::pi / 3)};
        for (int k = -lines; k <= lines; ++k) {
            const Point p = moved(origin, {-u.y, u.x}, k * height);
            add_trace(model, {moved(p, u, -reach), moved(p, u, reach)});
        }
    }
}

TEST(DegenerateGeometry, ALatticeOfTrianglesInAParallelogramOfItsOwnLines) {
    // 9 by 14 rhombs of two triangles each; no corner is a grid point, and the outline runs along joints.
    const Point origin{0.123456789, 0.2718281828};
    const Point slant{0.5, std::sqrt(3) / 2};
    SlopeModel model = rectangle(1, 1);
    model.outline = {origin,
                     {origin.x + 14, origin.y},
                     {origin.x + 14 + 9 * slant.x, origin.y + 9 * slant.y},
                     moved(origin, slant, 9)};
    add_triangle_lattice(model, origin, 30, 40);
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 252u);
    EXPECT_NEAR(result.report.sizes.smallest_area, std::sqrt(3) / 4, 2e-6);
    EXPECT_NEAR(result.report.sizes.largest_area, std::sqrt(3) / 4, 2e-6);
}

TEST(DegenerateGeometry, ALatticeOfTrianglesInARectangle) {
    // Each joint adds one block; each interior corner of the lattice, where three joints meet, adds two.
    const Point origin{0.123456789, 0.2};
    const double width = 10.2, height = 10.4, row = std::sqrt(3) / 2;
    SlopeModel model = rectangle(width, height);
    add_triangle_lattice(model, origin, 40, 40);
    int corners = 0, joints = 0;
    for (int j = -30; j <= 30; ++j)
        for (int i = -60; i <= 60; ++i) {
            const double x = origin.x + i + 0.5 * j, y = origin.y + row * j;
            corners += x > 0 && x < width && y > 0 && y < height;
        }
    for (const Trace& trace : model.traces) {
        const Point &a = trace.points[0], &b = trace.points[1];
        int left = 0;
        for (const Point& c : model.outline)
            left += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
        joints += left > 0 && left < 4;
    }
    EXPECT_EQ(cut(model).mesh.block_count(), static_cast<std::size_t>(1 + joints + 2 * corners));
}

TEST(DegenerateGeometry, AJointThatEndsJustShortOfAnother) {
    const Point a{0.3, -1}, b{2.1, 4}, u{-0.9, 0.37};
    for (const double gap : {0.0, 1e-12, 1e-9, 1e-7, -1e-12, -1e-9, -1e-7})
        for (const double t : {0.31, 0.5, 0.777}) {
            SlopeModel model = rectangle(3, 3);
            const Point meet{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            add_trace(model, {a, b}, "long");
            add_trace(model, {moved(meet, u, gap), moved(meet, u, 9)}, "short");
            const CutResult result = cut(model);
            EXPECT_EQ(result.mesh.block_count(), 3u) << gap << ' ' << t;
            EXPECT_LE(result.report.largest_snap, 1.5 * model.grid);
        }
    SlopeModel model = rectangle(3, 3);
    add_trace(model, {a, b});
    add_trace(model, {{1.2 - 3e-6, 1.5}, {-1, 1.5}});  // a gap of 2.8e-6 m stays open on this grid
    EXPECT_EQ(cut(model).mesh.block_count(), 2u);
}

// An end is joined up to an eighth of a cell, wherever the other joint lies in its cell: a vertical or
// horizontal joint may run along a cell's side with the end just beyond it.
TEST(DegenerateGeometry, AJointThatEndsWithinAnEighthOfACellOfAHorizontalJointOrTheBoundary) {
    for (const double grid : {0x1p-20, 0x1p-7})
        for (const double place : {0.0, 0.25, 0.49, 0.5 - 1e-9 / grid, 0.5, 0.51, 0.8})
            for (const double gap : {0.0, 1e-9, 2e-9, 1e-7, 0.05 * grid, 0.124 * grid})
                for (const double side : {1.0, -1.0}) {
                    const double level = 1.5 + place * grid, end = level + side * gap;
                    SlopeModel model = rectangle(3, 3);
                    model.grid = grid;
                    add_trace(model, {{-1, level}, {4, level}}, "level");
                    add_trace(model, {{1.1, end}, {1.1, side > 0 ? 4.0 : -1.0}}, "short");
                    const CutResult result = cut(model);
                    EXPECT_EQ(result.mesh.block_count(), 3u) << grid << ' ' << place << ' ' << gap;
                    EXPECT_LE(result.report.largest_snap, 1.5 * grid);
                    SlopeModel rim = rectangle(3, 3);
                    rim.grid = grid;
                    rim.outline[2].y = rim.outline[3].y = level;
                    add_trace(rim, {{1.1, level - gap}, {1.1, -1}}, "short");
                    EXPECT_EQ(cut(rim).mesh.block_count(), 2u) << grid << ' ' << place << ' ' << gap;
                }
}

// The same in any direction: the larger of the gap's x and y components counts.
TEST(DegenerateGeometry, AJointThatEndsWithinAnEighthOfACellOfAnotherInAnyDirection) {
    std::mt19937 random(5);
    const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-32; };
    for (const double grid : {0x1p-20, 0x1p-7})
        for (int k = 0; k < 1000; ++k) {
            SlopeModel model = rectangle(3, 3);
            model.grid = grid;
            // Every fourth is nearly horizontal or vertical.
            const double angle = k % 4 == 0 ? (k % 8 == 0 ? 0 : std::numbers::pi / 2) +
                                                  (uniform() - 0.5) * std::pow(10, -8 * uniform())
                                            : std::numbers::pi * uniform();
            const Point u{std::cos(angle), std::sin(angle)}, across{-u.y, u.x};
            const Point middle{1.3 + 0.4 * uniform(), 1.3 + 0.4 * uniform()};
            add_trace(model, {moved(middle, u, -5), moved(middle, u, 5)}, "long");
            const double gap =
                0.124 * grid / std::max(std::abs(u.x), std::abs(u.y)) * std::pow(10, -4 * uniform());
            const Point end = moved(moved(middle, u, 0.4 * (uniform() - 0.5)), across, gap);
            const double turn = angle + std::numbers::pi * (0.1 + 0.8 * uniform());
            add_trace(model, {end, moved(end, {std::cos(turn), std::sin(turn)}, 5)}, "short");
            const CutResult result = cut(model, false);
            EXPECT_EQ(result.mesh.block_count(), 3u) << grid << ' ' << k << ' ' << angle;
            EXPECT_LE(result.report.largest_snap, 1.5 * grid);
        }
}

TEST(DegenerateGeometry, AJointThroughCornersOfOthersAndOfTheOutline) {
    SlopeModel model = rectangle(4, 4);
    add_trace(model, {{-1, -1}, {5, 5}});
    add_trace(model, {{0, 4}, {4, 0}});
    add_trace(model, {{0, 2}, {2, 2}, {3, 4}});
    EXPECT_EQ(cut(model).mesh.block_count(), 6u);
}

TEST(DegenerateGeometry, AJointThatLeavesAConcaveDomainAndComesBack) {
    SlopeModel model = rectangle(1, 1);
    model.outline = {{0, 0}, {4, 0}, {4, 1.3}, {1.1, 1.3}, {1.1, 4}, {0, 4}};  // an L
    add_trace(model,
              {{-1, 2.6}, {5, 0.2}});  // in at the left, out over the notch, in again, out at the right
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 3u);
    EXPECT_NEAR(result.report.domain_area, 4 * 1.3 + 1.1 * 2.7, 1e-5);
    // It crosses x = 1.1 at y = 1.76 and y = 1.3 at x = 2.25.
    EXPECT_NEAR(result.report.joints[0].retained, std::hypot(1.1, 0.44) + std::hypot(1.75, 0.7), 1e-5);
}

TEST(DegenerateGeometry, ATunnelOfSixtyFourSidesCutByJoints) {
    SlopeModel model = rectangle(20, 20);
    Tunnel tunnel;
    for (int k = 0; k < 64; ++k)
        tunnel.outline.push_back({10.1 + 3 * std::cos(2 * std::numbers::pi * (k + 0.5) / 64),
                                  9.9 + 3 * std::sin(2 * std::numbers::pi * (k + 0.5) / 64)});
    model.tunnels.push_back(tunnel);
    add_trace(model, {{-1, 9.3}, {21, 10.7}});
    add_trace(model, {{9.3, 21}, {10.7, -1}});
    add_trace(model, {{10, 10}, {11, 11}});  // within the tunnel
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 4u);
    EXPECT_EQ(result.report.holes, 0u);
    EXPECT_NEAR(result.report.domain_area, 400 - 32 * 9 * std::sin(2 * std::numbers::pi / 64), 1e-4);
    EXPECT_THAT(result.report.warnings, ElementsAre(HasSubstr("lies outside the rock")));
}

TEST(DegenerateGeometry, ATunnelThatDividesTheDomain) {
    SlopeModel model = rectangle(10, 10);
    model.tunnels.push_back({"adit", {{-1, 4}, {11, 5}, {11, 6}, {-1, 5}}, {}});
    add_trace(model, {{3, -1}, {3, 11}});
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 4u);
    EXPECT_NEAR(result.report.domain_area, 90, 1e-5);
}

TEST(DegenerateGeometry, LayersCutByAJoint) {
    SlopeModel model = rectangle(6, 6);
    for (int k = 0; k < 3; ++k)
        model.regions.push_back({"layer " + std::to_string(k),
                                 k % 2 == 0 ? "marl" : "limestone",
                                 "bedding",
                                 {{-1, 2.0 * k}, {7, 2.0 * k}, {7, 2.0 * k + 2}, {-1, 2.0 * k + 2}},
                                 {}});
    add_trace(model, {{2, -1}, {3, 7}}, "fault");
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 6u);
    EXPECT_EQ(result.report.domain_area, 36);
    EXPECT_EQ(result.mesh.block_materials.size(), 2u);
}

TEST(DegenerateGeometry, JointsWithoutEffectAreReported) {
    SlopeModel model = rectangle(2, 1);
    add_trace(model, {{1, 0.5}, {1, 0.5}}, "point");
    add_trace(model, {{5, 5}, {6, 6}}, "outside");
    add_trace(model, {{-1, 0}, {3, 0}}, "rim");
    add_trace(model, {{-1, 0.5}, {3, 0.5}}, "useful");
    add_trace(model, {{0.2, 0.7}, {0.4, 0.7}}, "useful");
    const CutResult result = cut(model);
    EXPECT_EQ(result.mesh.block_count(), 2u);
    EXPECT_THAT(result.report.warnings,
                ElementsAre("1 trace of 'point' has no length on this grid and is dropped",
                            "1 trace of 'outside' lies outside the rock and is dropped",
                            "1 trace of 'rim' runs along a free face only, which stays free"));
}

TEST(DegenerateGeometry, NodesAndDensities) {
    SlopeModel model = rectangle(10, 10);
    add_trace(model, {{-1, 5}, {11, 5}}, "long");
    add_trace(model, {{2, 3}, {2, 7}}, "short");   // crosses and ends in rock twice
    add_trace(model, {{6, 5}, {6, 9}}, "short");   // abuts and ends in rock
    add_trace(model, {{8, -3}, {8, 5}}, "short");  // abuts and reaches the rim; its middle lies in the rock
    const CutReport report = cut(model).report;
    EXPECT_EQ(report.blocks, 3u);
    EXPECT_EQ(report.topology.nodes.i, 3u);
    EXPECT_EQ(report.topology.nodes.y, 2u);
    EXPECT_EQ(report.topology.nodes.x, 1u);
    EXPECT_EQ(report.topology.nodes.edge, 3u);
    ASSERT_EQ(report.joints.size(), 2u);
    EXPECT_NEAR(report.joints[0].p10, 0.1, 1e-6);
    EXPECT_NEAR(report.joints[0].outside, 2, 1e-6);
    EXPECT_NEAR(report.joints[1].p20, 0.03, 1e-12);
    EXPECT_NEAR(report.joints[1].p21, 0.13, 1e-6);
    EXPECT_NEAR(report.joints[1].p10, 0.13, 1e-6);
    EXPECT_NEAR(report.joints[1].retained, 5, 1e-6);
    EXPECT_NEAR(report.joints[1].pruned, 8, 1e-6);
    EXPECT_NEAR(report.joints[1].input, 16, 1e-6);
    EXPECT_NEAR(report.joints[1].outside, 3, 1e-6);
}

TEST(DegenerateGeometry, AHoleOrTunnelOutsideTheRockIsReported) {
    const std::string domain =
        "[domain]\noutline = [[0, 0], [2, 0], [2, 1], [0, 1]]\nblock_material = \"rock\"\n";
    EXPECT_THAT(error_of([&] { cut(slope(domain + "holes = [[[3, 0], [4, 0], [4, 1]]]\n")); }),
                HasSubstr("slope.toml:4:9: hole 1 lies outside the outline"));
    const SlopeModel model =
        slope(domain + "[[tunnel]]\nname = \"far\"\nshape = \"circle\"\ncentre = [9, 9]\nradius = 1\n");
    EXPECT_THAT(cut(model).report.warnings, ElementsAre(HasSubstr("tunnel 'far' lies outside the outline")));
}

TEST(DegenerateGeometry, ATraceDrawnTwiceIsCountedOnceAndTold) {
    const std::string trace = "[[traces]]\njoint_material = \"fault\"\npoints = ";
    const CutReport report =
        cut(slope("[domain]\noutline = [[0, 0], [10, 0], [10, 10], [0, 10]]\nblock_material = \"rock\"\n" +
                  trace + "[[0, 5], [4, 5.5], [10, 5]]\n" + trace + "[[10, 5], [4, 5.5], [0, 5]]\n" + trace +
                  "[[0, 5], [4, 5.5], [10, 5]]\n" + trace + "[[0, 5], [4, 5.5]]\n"))
            .report;
    EXPECT_EQ(report.blocks, 2u);
    EXPECT_EQ(report.joints[0].traces, 2u);
    EXPECT_THAT(
        report.warnings,
        ElementsAre(
            HasSubstr("2 traces of 'fault' repeat earlier ones and are dropped, the first at (10, 5)"),
            HasSubstr("1 joint of 'fault' runs along earlier ones for 4.03 m, counted once")));
    // The whole trace and none of its piece: hypot(4, 0.5) + hypot(6, 0.5).
    EXPECT_NEAR(report.joints[0].retained, std::hypot(4, 0.5) + std::hypot(6, 0.5), 1e-5);
    EXPECT_NEAR(report.joints[0].repeated, std::hypot(4, 0.5), 1e-5);
    EXPECT_NEAR(report.joints[0].p21, (std::hypot(4, 0.5) + std::hypot(6, 0.5)) / 100, 1e-7);
    EXPECT_NEAR(report.joints[0].p20, 0.01, 1e-12);
}

TEST(DegenerateGeometry, KeptIslandIsReportedWithPositionAndArea) {
    SlopeModel model = rectangle(10, 10);
    add_trace(model, {{4, 4}, {6, 4}, {6, 7}, {4, 7}, {4, 4}});
    const CutResult result = cut(model);
    EXPECT_EQ(result.report.blocks, 2u);
    EXPECT_EQ(result.report.islands, 1u);
    EXPECT_THAT(result.report.warnings,
                ElementsAre(AllOf(HasSubstr("island of 6 m2"), HasSubstr("is kept within one block"))));
}

}  // namespace
}  // namespace rockslope::blockgen::degenerate_geometry_test
