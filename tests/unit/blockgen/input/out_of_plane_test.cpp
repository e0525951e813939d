#include "blockgen/input/out_of_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace rockslope::blockgen::out_of_plane_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A point 10 m from the origin in a direction clockwise from north.
Point towards(double azimuth) {
    return {10 * std::sin(azimuth * degree), 10 * std::cos(azimuth * degree)};
}

TEST(OutOfPlane, OnLevelGroundIsTheDipTimesTheAngleToTheStrike) {
    for (const double dip : {0.0, 1e-9, 30.0, 60.0, 90.0})
        for (const double off_strike : {0.0, 20.0, 90.0, 160.0, 180.0}) {
            const JointPlane plane{dip * degree, 120 * degree};
            const std::vector<Point> trace = {{0, 0}, {3, 4}, towards(30 + off_strike)};
            EXPECT_NEAR(angle_out_of_plane(trace, {}, plane),
                        std::asin(std::sin(dip * degree) * std::sin(off_strike * degree)), 1e-12)
                << dip << ' ' << off_strike;
        }
}

TEST(OutOfPlane, IsZeroForPointsOfThePlane) {
    // A plane that dips at 50 deg towards 200 deg falls by tan 50 deg for each metre in that direction.
    const JointPlane plane{50 * degree, 200 * degree};
    for (const double azimuth : {200.0, 20.0, 110.0, 245.0}) {
        const std::vector<Point> trace = {{0, 0}, towards(azimuth)};
        const double fall = 10 * std::cos((azimuth - 200) * degree) * std::tan(50 * degree);
        EXPECT_NEAR(angle_out_of_plane(trace, std::vector{80.0, 80 - fall}, plane), 0, 1e-12) << azimuth;
    }
    // Up where the plane goes down.
    const std::vector<Point> down_dip = {{0, 0}, towards(200)};
    EXPECT_NEAR(angle_out_of_plane(down_dip, std::vector{0.0, 10 * std::tan(30 * degree)}, plane),
                80 * degree, 1e-12);
    EXPECT_EQ(angle_out_of_plane(std::vector<Point>{{1, 2}, {3, 4}, {1, 2}}, {}, plane), 0);
}

}  // namespace
}  // namespace rockslope::blockgen::out_of_plane_test
