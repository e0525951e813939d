#include <gtest/gtest.h>

#include <cmath>

#include "blockgen/arrangement/voronoi.hpp"
#include "common/base/input_error.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::voronoi_set_test {
namespace {

const std::string cells = R"(
seed = 3
[domain]
outline = [[0, 0], [60, 0], [60, 40], [0, 40]]
block_material = "rock"
[[joint_set]]
name = "cells"
kind = "voronoi"
count = 1000
)";

double area_spread(const BlockMesh& mesh) {
    double sum = 0, squares = 0;
    for (const BlockIndex b : mesh.blocks()) {
        const double area = block_area(mesh, b);
        sum += area;
        squares += area * area;
    }
    const auto n = static_cast<double>(mesh.block_count());
    return std::sqrt(squares / n - sum * sum / n / n) / (sum / n);
}

TEST(Voronoi, FourPointsOfASquareMakeACross) {
    const Bounds box{{-1, -1}, {3, 3}};
    // Four more points far away bound the cells of the square by edges outside the box.
    const auto edges =
        voronoi_edges({{0, 0}, {2, 0}, {0, 2}, {2.0, 2.0}, {1, 90}, {1, -90}, {90, 1}, {-90, 1}}, 0, box);
    double length = 0;
    for (const auto& [a, b] : edges) {
        length += std::hypot(b.x - a.x, b.y - a.y);
        EXPECT_TRUE(std::abs(a.x - 1) < 1e-9 || std::abs(a.y - 1) < 1e-9);
    }
    EXPECT_NEAR(length, 8, 1e-9);
    EXPECT_TRUE(voronoi_edges({{0, 0}, {1, 1}}, 0, box).empty());
}

TEST(Voronoi, CellsFillTheDomain) {
    const CutResult result = cut(slope(cells));
    // A thousand points on average, plus cells cut by the boundary: the perimeter of 200 m meets about 0.7
    // times its length over the cell size of 1.55 m.
    EXPECT_NEAR(static_cast<double>(result.mesh.block_count()), 1000 + 0.7 * 200 / 1.55, 3 * std::sqrt(1000));
    EXPECT_LT(result.report.joints[0].pruned, 1e-4);
    EXPECT_EQ(result.report.topology.nodes.i, 0u);
    EXPECT_LT(static_cast<double>(result.report.topology.nodes.x),
              0.01 * static_cast<double>(result.report.topology.nodes.y));
    // Poisson-Voronoi edges have the length 2 sqrt(density) per area (Meijering 1953): 1.2910 1/m.
    EXPECT_NEAR(result.report.joints[0].p21, 2 * std::sqrt(1000 / 2400.0), 0.04);
}

TEST(Voronoi, RelaxedCellsAreMoreAlike) {
    const double at_random = area_spread(cut(slope(cells)).mesh);
    const double relaxed = area_spread(cut(slope(cells + "relaxation = 20\n")).mesh);
    EXPECT_GT(at_random, 0.45);  // 0.53 for unbounded Poisson cells
    EXPECT_LT(relaxed, 0.35);
}

TEST(Voronoi, KeysOfTheModelFile) {
    for (const char* bad : {"relaxation = -1", "relaxation = 1001", "angle = \"3 deg\"", "p21 = 3"})
        EXPECT_THROW(slope(cells + bad + "\n"), InputError) << bad;
    std::string none = cells;
    none.erase(none.find("count = 1000"));
    EXPECT_THROW(slope(none), InputError);
}

}  // namespace
}  // namespace rockslope::blockgen::voronoi_set_test
