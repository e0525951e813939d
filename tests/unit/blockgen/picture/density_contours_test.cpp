#include "blockgen/picture/density_contours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blockgen/picture/equal_area.hpp"

namespace rockslope::blockgen::density_contours_test {
namespace {

TEST(DensityContours, LieWhereTheDensityHasTheirValue) {
    std::vector<SpaceDirection> poles(40, direction_at({0.2, 0.3}));
    poles.resize(60, direction_at({-0.6, -0.5}));
    const AxisDensity density(poles);
    const std::vector<DensityContour> contours = density_contours(density);
    ASSERT_GE(contours.size(), 3u);
    EXPECT_GE(contours[0].density, 2);
    for (const DensityContour& contour : contours) {
        EXPECT_FALSE(contour.lines.empty());
        for (const auto& line : contour.lines)
            for (const Point& p : line) EXPECT_NEAR(density.at(direction_at(p)) / contour.density, 1, 1e-2);
    }
}

TEST(DensityContours, GoOnAtTheOtherSideOfTheRim) {
    // Poles one degree below the horizontal to the east: each contour has a part in the west.
    const AxisDensity density(std::vector<SpaceDirection>(30, downward_pole(1.5533, -1.5708)));
    for (const DensityContour& contour : density_contours(density)) {
        ASSERT_EQ(contour.lines.size(), 2u) << contour.density;
        std::vector<Point> ends;
        for (const auto& line : contour.lines) {
            for (const Point& p : line) EXPECT_LE(std::hypot(p.x, p.y), 1 + 1e-12);
            ends.insert(ends.end(), {line.front(), line.back()});
        }
        for (const Point& end : ends) {
            const bool has_opposite = std::any_of(ends.begin(), ends.end(), [&](const Point& other) {
                return std::hypot(end.x + other.x, end.y + other.y) < 1e-9;
            });
            EXPECT_TRUE(has_opposite) << contour.density << ": " << end.x << ' ' << end.y;
        }
    }
}

TEST(DensityContours, OfFewScatteredPolesAreNone) {
    std::vector<SpaceDirection> poles;
    for (const Point& p : {Point{0, 0}, Point{0.9, 0}, Point{0, 0.9}}) poles.push_back(direction_at(p));
    EXPECT_TRUE(density_contours(AxisDensity(poles)).empty());
}

}  // namespace
}  // namespace rockslope::blockgen::density_contours_test
