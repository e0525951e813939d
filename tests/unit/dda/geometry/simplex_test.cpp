#include "dda/geometry/simplex.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockslope::simplex_test {
namespace {

using dda::AreaMoments;
using dda::Vec2;

const std::vector<Vec2> unit_square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

AreaMoments of(const std::vector<Vec2>& ring) {
    const dda::CornerIndex ends[] = {0, static_cast<int>(ring.size())};
    return dda::integrate(ring, ends);
}

std::vector<Vec2> shifted(std::vector<Vec2> ring, const Vec2& by) {
    for (Vec2& v : ring) v += by;
    return ring;
}

/// Analytical moments of an axis-parallel rectangle about the origin.
struct Rectangle {
    double left, bottom, right, top;
    double area() const { return (right - left) * (top - bottom); }
    double x() const { return (left + right) / 2; }
    double y() const { return (bottom + top) / 2; }
    double xx() const { return area() * (std::pow(right - left, 2) / 12 + x() * x()); }
    double yy() const { return area() * (std::pow(top - bottom, 2) / 12 + y() * y()); }
    double xy() const { return area() * x() * y(); }
};

/// The moments of a signed union of rectangles about its centroid.
AreaMoments sum_of(const std::vector<std::pair<double, Rectangle>>& parts) {
    AreaMoments m;
    for (const auto& [sign, r] : parts) {
        m.area += sign * r.area();
        m.centroid += sign * r.area() * Vec2(r.x(), r.y());
        m.xx += sign * r.xx();
        m.yy += sign * r.yy();
        m.xy += sign * r.xy();
    }
    m.centroid /= m.area;
    m.xx -= m.area * m.centroid.x() * m.centroid.x();
    m.yy -= m.area * m.centroid.y() * m.centroid.y();
    m.xy -= m.area * m.centroid.x() * m.centroid.y();
    return m;
}

void expect_near(const AreaMoments& seen, const AreaMoments& expected, double tolerance) {
    EXPECT_NEAR(seen.area, expected.area, tolerance);
    EXPECT_NEAR((seen.centroid - expected.centroid).norm(), 0, tolerance);
    EXPECT_NEAR(seen.xx, expected.xx, tolerance);
    EXPECT_NEAR(seen.yy, expected.yy, tolerance);
    EXPECT_NEAR(seen.xy, expected.xy, tolerance);
}

// A dozen operations on numbers of order one: 1e-14 is some fifty roundings.
constexpr double rounding = 1e-14;

TEST(Simplex, UnitSquare) {
    expect_near(of(unit_square), {1, {.5, .5}, 1. / 12, 1. / 12, 0}, rounding);
}

TEST(Simplex, RightTriangle) {
    // Base b, height h, right angle at the origin: b h / 2, b^3 h / 36, b h^3 / 36, -b^2 h^2 / 72.
    const double b = 3;
    const double h = 2;
    expect_near(of({{0, 0}, {b, 0}, {0, h}}),
                {b * h / 2, {b / 3, h / 3}, b * b * b * h / 36, b * h * h * h / 36, -b * b * h * h / 72},
                rounding);
}

TEST(Simplex, RegularPolygonNearsTheCircle) {
    // n sin(2 pi/n)/2 and n sin(2 pi/n)(2 + cos(2 pi/n))/24 for radius 1.
    constexpr int n = 360;
    std::vector<Vec2> ring;
    for (int k = 0; k < n; ++k)
        ring.emplace_back(std::cos(k * 2 * std::numbers::pi / n), std::sin(k * 2 * std::numbers::pi / n));
    const double step = 2 * std::numbers::pi / n;
    const double second = n * std::sin(step) * (2 + std::cos(step)) / 24;
    expect_near(of(ring), {n * std::sin(step) / 2, {0, 0}, second, second, 0}, 1e-13);
}

TEST(Simplex, ConcavePolygonIsASumOfRectangles) {
    const std::vector<Vec2> ell = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
    expect_near(of(ell), sum_of({{1, {0, 0, 3, 1}}, {1, {0, 1, 1, 4}}}), 1e-13);
}

TEST(Simplex, HolesAreSubtracted) {
    const std::vector<Vec2> rings = {{0, 0}, {6, 0}, {6, 4}, {0, 4},  //
                                     {1, 1}, {1, 2}, {3, 2}, {3, 1},  // clockwise
                                     {4, 2}, {4, 3}, {5, 3}, {5, 2}};
    const dda::CornerIndex ends[] = {20, 24, 28, 32};  // offsets need not start at 0
    expect_near(dda::integrate(rings, ends),
                sum_of({{1, {0, 0, 6, 4}}, {-1, {1, 1, 3, 2}}, {-1, {4, 2, 5, 3}}}), 1e-12);
}

TEST(Simplex, StraightAndRepeatedVerticesChangeNothing) {
    expect_near(of({{0, 0}, {.5, 0}, {1, 0}, {1, 0}, {1, 1}, {.25, 1}, {0, 1}}), of(unit_square), rounding);
}

TEST(Simplex, StartingVertexDoesNotMatter) {
    expect_near(of({{1, 1}, {1, 4}, {0, 4}, {0, 0}, {3, 0}, {3, 1}}),
                of({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}), 1e-13);
}

// At a distance of 1e6 m coordinates resolve 2^-33 m. The corners of the square are exact, so that no digit
// of the moments may be lost.
TEST(Simplex, FarFromTheOriginLosesNoDigits) {
    const Vec2 far(1e6, -1e6);
    const AreaMoments m = of(shifted(unit_square, far));
    EXPECT_EQ(m.area, 1);
    EXPECT_EQ(m.centroid, far + Vec2(.5, .5));
    EXPECT_NEAR(m.xx, 1. / 12, rounding);
    EXPECT_NEAR(m.yy, 1. / 12, rounding);
    EXPECT_NEAR(m.xy, 0, rounding);
}

TEST(Simplex, SliverKeepsItsArea) {
    const double thin = std::ldexp(1, -30);
    const AreaMoments m = of({{0, 0}, {1, 0}, {1, thin}, {0, thin}});
    EXPECT_DOUBLE_EQ(m.area, thin);
    EXPECT_NEAR(m.xx / (thin / 12), 1, rounding);
    EXPECT_NEAR(m.yy / (thin * thin * thin / 12), 1, 1e-9);
}

}  // namespace
}  // namespace rockslope::simplex_test
