#include "common/geometry/polygon.hpp"

#include <gtest/gtest.h>

namespace rockslope::polygon_test {
namespace {

TEST(Polygon, CentroidIsThatOfTheArea) {
    // An L of two rectangles: 4 x 1 with centre (2, 0.5), and 1 x 2 with centre (0.5, 2).
    const Ring shape = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    const Point middle = centroid(shape);
    EXPECT_DOUBLE_EQ(middle.x, (4 * 2 + 2 * 0.5) / 6);
    EXPECT_DOUBLE_EQ(middle.y, (4 * 0.5 + 2 * 2.0) / 6);
    const Ring backwards(shape.rbegin(), shape.rend());
    EXPECT_NEAR(centroid(backwards).x, middle.x, 1e-12);
}

TEST(Polygon, CentroidKeepsItsDigitsFarFromTheOrigin) {
    const double far = 1 << 23;
    const Ring square = {{far, far}, {far + 1, far}, {far + 1, far + 1}, {far, far + 1}};
    EXPECT_DOUBLE_EQ(centroid(square).x, far + 0.5);
}

TEST(Polygon, CentroidOfALineIsItsFirstPoint) {
    EXPECT_EQ(centroid(Ring{{3, 4}}), (Point{3, 4}));
    EXPECT_EQ(centroid(Ring{{3, 4}, {5, 6}}), (Point{3, 4}));
}

}  // namespace
}  // namespace rockslope::polygon_test
