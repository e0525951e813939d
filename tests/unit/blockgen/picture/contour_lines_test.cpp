#include "blockgen/picture/contour_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rockslope::blockgen::contour_lines_test {
namespace {

template <class Function>
std::vector<double> values_of(const DiscGrid& grid, const Function& function) {
    std::vector<double> values;
    for (std::size_t ring = 0; ring <= grid.rings; ++ring)
        for (std::size_t spoke = 0; spoke < grid.spokes; ++spoke)
            values.push_back(function(grid.node(ring, spoke)));
    return values;
}

/// The largest distance of the contour of exp(-r^2) about a point from the circle of radius 0.3, at the ends
/// and in the middles of its pieces.
double circle_error(const Point& centre, std::size_t rings) {
    const DiscGrid grid{rings, 4 * rings};
    const auto radius = [&](const Point& p) { return std::hypot(p.x - centre.x, p.y - centre.y); };
    const auto lines =
        contour_lines(grid, values_of(grid, [&](const Point& p) { return std::exp(-radius(p) * radius(p)); }),
                      std::exp(-0.09));
    EXPECT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].front(), lines[0].back());
    double error = 0;
    for (std::size_t k = 1; k < lines[0].size(); ++k) {
        const Point &a = lines[0][k - 1], &b = lines[0][k];
        error = std::max(
            {error, std::abs(radius(a) - 0.3), std::abs(radius({(a.x + b.x) / 2, (a.y + b.y) / 2}) - 0.3)});
    }
    return error;
}

TEST(ContourLines, OfACircleConvergeWithTheSecondOrder) {
    for (const Point& centre : {Point{0.03, 0.01}, Point{0.02, 0.41}, Point{-0.4, 0.3}}) {
        const double coarse = circle_error(centre, 20), fine = circle_error(centre, 80);
        EXPECT_LT(coarse, 4e-3);
        EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2, 0.35) << centre.x << ' ' << centre.y;
    }
}

TEST(ContourLines, EndOnTheCircle) {
    const DiscGrid grid{10, 40};
    const auto lines = contour_lines(grid, values_of(grid, [](const Point& p) { return p.x; }), 0.52);
    ASSERT_EQ(lines.size(), 1u);
    for (const Point& end : {lines[0].front(), lines[0].back()}) {
        EXPECT_NEAR(end.x, 0.52, 1e-12);
        EXPECT_NEAR(std::hypot(end.x, end.y), 1, 4e-3);
    }
    for (const Point& p : lines[0]) EXPECT_LE(std::hypot(p.x, p.y), 1 + 1e-15);
}

TEST(ContourLines, OfASaddleDoNotCross) {
    // Above and below it the two branches of a hyperbola about other axes.
    const DiscGrid grid{9, 36};
    const auto saddle = values_of(grid, [](const Point& p) { return (p.x - 0.31) * (p.y - 0.23); });
    for (const double level : {-1e-3, 1e-3}) {
        const auto lines = contour_lines(grid, saddle, level);
        ASSERT_EQ(lines.size(), 2u);
        for (const auto& line : lines) EXPECT_NE(line.front(), line.back());
    }
}

TEST(ContourLines, OfALevelThatIsNotReachedAreNone) {
    const DiscGrid grid{4, 8};
    EXPECT_TRUE(contour_lines(grid, values_of(grid, [](const Point& p) { return p.y; }), 1.5).empty());
}

}  // namespace
}  // namespace rockslope::blockgen::contour_lines_test
