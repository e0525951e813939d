#include "common/geometry/vertical_sections.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rockslope::vertical_sections_test {
namespace {

// A step of two boxes, and a triangle that floats above the lower one.
const std::vector<Ring> step = {
    {{0, 0}, {2, 0}, {2, 3}, {0, 3}}, {{2, 0}, {6, 0}, {6, 1}, {2, 1}}, {{3, 2}, {5, 2}, {4, 4}}};

TEST(VerticalSections, GivesTheTopAndTheLengthInside) {
    const VerticalSections sections(step);
    EXPECT_EQ(sections.at(1).top, 3);
    EXPECT_EQ(sections.at(1).length, 3);
    EXPECT_EQ(sections.at(2.5).top, 1);
    EXPECT_EQ(sections.at(4).top, 4);
    EXPECT_EQ(sections.at(4).length, 1 + 2) << "the gap does not count";
    EXPECT_EQ(sections.at(3.5).top, 3);
    EXPECT_EQ(sections.at(3.5).length, 1 + 1);
    EXPECT_EQ(sections.corners(), (std::vector<double>{0, 2, 3, 4, 5, 6}));
}

TEST(VerticalSections, HasTwoLimitsAtAStep) {
    const VerticalSections sections(step);
    EXPECT_EQ(sections.left_of(2).top, 3);
    EXPECT_EQ(sections.left_of(2).length, 3);
    EXPECT_EQ(sections.right_of(2).top, 1);
    EXPECT_EQ(sections.right_of(2).length, 1);
    EXPECT_EQ(sections.at(2).top, 3);
    EXPECT_EQ(sections.at(2).length, 3);
}

TEST(VerticalSections, EndsWithTheRings) {
    const VerticalSections sections(step);
    EXPECT_EQ(sections.at(0).top, 3);
    EXPECT_FALSE(sections.left_of(0).top);
    EXPECT_EQ(sections.at(6).length, 1);
    EXPECT_FALSE(sections.right_of(6).top);
    for (const double x : {-1.0, 7.0}) EXPECT_FALSE(sections.at(x).top);
    EXPECT_FALSE(VerticalSections({}).at(0).top);
}

// A hole that is joined to the outline by a slit, and a ring that turns clockwise.
TEST(VerticalSections, LeavesOutHoles) {
    std::vector<Ring> rings = {
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}};
    EXPECT_EQ(VerticalSections(rings).at(2).length, 2);
    EXPECT_EQ(VerticalSections(rings).at(2).top, 4);
    std::reverse(rings[0].begin(), rings[0].end());
    EXPECT_EQ(VerticalSections(rings).at(2).length, 2);
}

// The integral of the length is the area, at whatever place.
TEST(VerticalSections, MeasureTheAreaFarFromTheOrigin) {
    std::vector<Ring> far = step;
    for (Ring& ring : far)
        for (Point& p : ring) p = {p.x + 700000, p.y + 5000};
    const VerticalSections sections(far);
    double area = 0;
    for (int k = 0; k < 600; ++k) area += sections.at(700000.005 + k * 0.01).length * 0.01;
    EXPECT_NEAR(area, 2 * 3 + 4 * 1 + 2, 1e-6);
}

}  // namespace
}  // namespace rockslope::vertical_sections_test
