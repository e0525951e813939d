// Invariances of the cut: order and direction of the joints, translation and rotation of the section.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "blockgen/mesh/block_file.hpp"
#include "blockgen/mesh/measures.hpp"
#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::cut_properties_test {
namespace {

/// Random joints; many end on others, are parallel to others or share ends with others. Coordinates are
/// multiples of 2^-24, so that shifts by whole grid cells are exact.
SlopeModel random_slope(unsigned seed, int joints) {
    std::mt19937 random(seed);
    const auto coordinate = [&](double extent) {
        return std::round(0x1p24 * extent * static_cast<double>(random()) * 0x1p-32) * 0x1p-24;
    };
    SlopeModel model = rectangle(16, 12);
    model.outline = {{0, 0}, {16, 0.25}, {15.5, 12}, {9, 7.75}, {-0.5, 12}};
    for (int k = 0; k < joints; ++k) {
        Point a{coordinate(18) - 1, coordinate(14) - 1}, b{coordinate(18) - 1, coordinate(14) - 1};
        if (k % 4 == 1) a = model.traces.back().points[1];
        if (k % 4 == 2) {
            const std::vector<Point>& last = model.traces[static_cast<std::size_t>(k) / 2].points;
            a = {(last[0].x + last[1].x) / 2, (last[0].y + last[1].y) / 2};
        }
        add_trace(model, {a, b});
    }
    return model;
}

template <class Map>
SlopeModel mapped(SlopeModel model, const Map& map) {
    for (Point& p : model.outline) p = map(p);
    for (Trace& trace : model.traces)
        for (Point& p : trace.points) p = map(p);
    return model;
}

std::vector<double> sorted_areas(const BlockMesh& mesh) {
    std::vector<double> areas;
    for (const BlockIndex b : mesh.blocks()) areas.push_back(block_area(mesh, b));
    std::sort(areas.begin(), areas.end());
    return areas;
}

class CutProperties : public testing::TestWithParam<unsigned> {
  protected:
    SlopeModel model_ = random_slope(GetParam(), 60);
    BlockMesh mesh_ = cut(model_).mesh;
};

TEST_P(CutProperties, TheOrderOfTheJoints) {
    std::mt19937 random(GetParam() + 100);
    std::shuffle(model_.traces.begin(), model_.traces.end(), random);
    const BlockMesh other = cut(model_).mesh;
    EXPECT_GT(mesh_.block_count(), 50u);
    EXPECT_EQ(mesh_.vertices, other.vertices);
    EXPECT_EQ(mesh_.corners, other.corners);
    EXPECT_EQ(mesh_.ring_corners, other.ring_corners);
    EXPECT_EQ(block_file_text(mesh_), block_file_text(other));
}

TEST_P(CutProperties, TheDirectionOfTheJoints) {
    for (Trace& trace : model_.traces) std::reverse(trace.points.begin(), trace.points.end());
    const BlockMesh other = cut(model_).mesh;
    EXPECT_EQ(mesh_.vertices, other.vertices);
    EXPECT_EQ(mesh_.corners, other.corners);
    EXPECT_EQ(mesh_.edge_marks, other.edge_marks);
}

TEST_P(CutProperties, AShiftByWholeCells) {
    const Point shift{466000 + 12345 * 0x1p-20, 6691582 - 777 * 0x1p-20};
    const BlockMesh other = cut(mapped(model_, [&](const Point& p) {
                                return Point{p.x + shift.x, p.y + shift.y};
                            })).mesh;
    ASSERT_EQ(mesh_.vertices.size(), other.vertices.size());
    for (const VertexIndex v : mesh_.vertices.indices()) {
        EXPECT_EQ(other.vertices[v].x - shift.x, mesh_.vertices[v].x);
        EXPECT_EQ(other.vertices[v].y - shift.y, mesh_.vertices[v].y);
    }
    EXPECT_EQ(mesh_.corners, other.corners);
}

TEST_P(CutProperties, AQuarterTurn) {
    const BlockMesh other = cut(mapped(model_, [](const Point& p) { return Point{-p.y, p.x}; })).mesh;
    const std::vector<double> before = sorted_areas(mesh_), after = sorted_areas(other);
    ASSERT_EQ(before.size(), after.size());
    EXPECT_EQ(mesh_.vertices.size(), other.vertices.size());
    // Cells are half-open, so a crossing on a cell's edge may be rounded to the other side. The area then
    // changes by up to one cell times the block's perimeter.
    for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(before[k], after[k], 60 * model_.grid);
}

TEST_P(CutProperties, TheSameJointsTwice) {
    const std::vector<Trace> once = model_.traces;
    model_.traces.insert(model_.traces.end(), once.begin(), once.end());
    const BlockMesh other = cut(model_).mesh;
    EXPECT_EQ(mesh_.vertices, other.vertices);
    EXPECT_EQ(mesh_.corners, other.corners);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CutProperties, testing::Range(1u, 7u));

}  // namespace
}  // namespace rockslope::blockgen::cut_properties_test
