#include "blockgen/picture/equal_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rockslope::blockgen::equal_area_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(EqualArea, PutsPolesOppositeToTheirDipDirection) {
    // The pole of a plane with the dip t plunges by 90 - t towards the direction opposite to its dip, so it
    // lies at sqrt(2) sin(t / 2) from the centre.
    for (const double dip : {0.0, 1e-9, 10.0, 45.0, 60.0, 90.0})
        for (const double direction : {0.0, 30.0, 120.0, 270.0, 359.0}) {
            const Point p = equal_area(downward_pole(dip * degree, direction * degree));
            const double radius = std::sqrt(2.0) * std::sin(dip * degree / 2);
            EXPECT_NEAR(p.x, -radius * std::sin(direction * degree), 1e-14) << dip << ' ' << direction;
            EXPECT_NEAR(p.y, -radius * std::cos(direction * degree), 1e-14) << dip << ' ' << direction;
        }
    // 30/090 to the west: sqrt(2) sin 15.
    EXPECT_NEAR(equal_area(downward_pole(30 * degree, 90 * degree)).x, -0.3660254037844386, 1e-14);
}

TEST(EqualArea, KeepsAreas) {
    // A strip of the sphere between the angles t and t + dt to the vertical has the area 2 pi (cos t -
    // cos(t + dt)); the ring on the net has pi (r1^2 - r0^2), which is the same over two.
    for (int k = 0; k < 9; ++k) {
        const double t0 = 10 * k * degree, t1 = t0 + 10 * degree;
        const double r0 = equal_area({std::sin(t0), 0, std::cos(t0)}).x,
                     r1 = equal_area({std::sin(t1), 0, std::cos(t1)}).x;
        EXPECT_NEAR(r1 * r1 - r0 * r0, std::cos(t0) - std::cos(t1), 1e-14);
    }
}

TEST(EqualArea, DrawsLinesThatPointUpwardsByTheirLowerEnd) {
    const Point up = equal_area({0.48, 0.6, -0.64}), down = equal_area({-0.48, -0.6, 0.64});
    EXPECT_EQ(up.x, down.x);
    EXPECT_EQ(up.y, down.y);
}

TEST(EqualArea, HasAnInverse) {
    for (const Point& p : {Point{0, 0}, Point{0.3, -0.4}, Point{-0.6, 0.8}}) {
        const SpaceDirection line = direction_at(p);
        EXPECT_NEAR(dot(line, line), 1, 1e-15);
        EXPECT_NEAR(equal_area(line).x, p.x, 1e-15);
        EXPECT_NEAR(equal_area(line).y, p.y, 1e-15);
    }
}

TEST(GreatCircle, IsOfLinesAcrossThePole) {
    for (const double dip : {0.0, 20.0, 90.0})
        for (const double direction : {0.0, 100.0, 290.0}) {
            const SpaceDirection pole = downward_pole(dip * degree, direction * degree);
            const std::vector<Point> curve = great_circle(dip * degree, direction * degree);
            for (const Point& p : curve) {
                const SpaceDirection line = direction_at(p);
                EXPECT_NEAR(line.east * pole.east + line.north * pole.north + line.down * pole.down, 0,
                            1e-12);
            }
            // It begins and ends on the rim, on opposite sides.
            EXPECT_NEAR(std::hypot(curve.front().x, curve.front().y), 1, 1e-12);
            EXPECT_NEAR(curve.front().x + curve.back().x, 0, 1e-12);
            EXPECT_NEAR(curve.front().y + curve.back().y, 0, 1e-12);
            // The middle is the line of dip.
            const SpaceDirection dips = direction_at(curve[curve.size() / 2]);
            EXPECT_NEAR(dips.down, std::sin(dip * degree), 1e-12);
            EXPECT_NEAR(dips.east, std::cos(dip * degree) * std::sin(direction * degree), 1e-12);
        }
}

TEST(SmallCircle, IsOfLinesAtOneAngleToTheNorth) {
    for (const double angle : {10.0, 90.0, 150.0})
        for (const Point& p : small_circle(angle * degree))
            EXPECT_NEAR(direction_at(p).north, std::cos(angle * degree), 1e-12) << angle;
}

}  // namespace
}  // namespace rockslope::blockgen::equal_area_test
