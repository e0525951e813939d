#include "common/geometry/axis_density.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace rockslope::axis_density_test {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180;

double uniform_number(std::mt19937_64& generator) {
    return (static_cast<double>(generator() >> 11u) + 0.5) * 0x1p-53;
}

SpaceDirection at_angles(double from_vertical, double azimuth) {
    return {std::sin(from_vertical) * std::sin(azimuth), std::sin(from_vertical) * std::cos(azimuth),
            std::cos(from_vertical)};
}

std::vector<SpaceDirection> uniform_axes(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::vector<SpaceDirection> axes;
    while (axes.size() < count) {
        const double height = uniform_number(generator);
        axes.push_back(at_angles(std::acos(height), 2 * pi * uniform_number(generator)));
    }
    return axes;
}

/// Axes of Fisher's distribution about the direction of a vertical angle and an azimuth, of mixed signs.
std::vector<SpaceDirection> cluster(std::size_t count, double k, double angle, double azimuth) {
    std::mt19937_64 generator(7);
    std::vector<SpaceDirection> axes;
    while (axes.size() < count) {
        const double cosine = 1 + std::log(1 - uniform_number(generator) * (1 - std::exp(-2 * k))) / k;
        const SpaceDirection a = at_angles(std::acos(cosine), 2 * pi * uniform_number(generator));
        // Turned about the north axis, then about the vertical.
        const double x = a.down * std::sin(angle) + a.east * std::cos(angle),
                     down = a.down * std::cos(angle) - a.east * std::sin(angle),
                     sign = axes.size() % 2 == 0 ? 1 : -1;
        axes.push_back({sign * (x * std::sin(azimuth) + a.north * std::cos(azimuth)),
                        sign * (x * std::cos(azimuth) - a.north * std::sin(azimuth)), sign * down});
    }
    return axes;
}

/// Mean over the hemisphere from the middles of cells of equal area, `steps` by 4 `steps` of them.
double mean_density(const AxisDensity& density, int steps) {
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < 4 * steps; ++j)
            sum += density.at(at_angles(std::acos((i + 0.5) / steps), 2 * pi * (j + 0.5) / (4 * steps)));
    return sum / (4.0 * steps * steps);
}

TEST(AxisDensity, HasTheMeanOne) {
    for (const double angle : {0.0, 50.0, 90.0}) {
        const AxisDensity density(cluster(60, 30, angle * degree, 0.3));
        const double coarse = std::abs(mean_density(density, 10) - 1),
                     fine = std::abs(mean_density(density, 40) - 1);
        EXPECT_LT(coarse, 6e-2) << angle;
        EXPECT_LT(fine, std::max(coarse / 8, 1e-6)) << angle;
        EXPECT_LT(std::abs(mean_density(density, 160) - 1), 3e-4) << angle;
    }
    // A single axis has the widest kernel, and many of one direction the narrowest.
    EXPECT_NEAR(mean_density(AxisDensity(std::vector<SpaceDirection>{{0, 0, 1}}), 160), 1, 1e-4);
    EXPECT_NEAR(mean_density(AxisDensity(std::vector<SpaceDirection>(9000, at_angles(1, 2))), 160), 1, 1e-4);
}

TEST(AxisDensity, OfUniformAxesIsFlat) {
    for (const std::size_t count : {30u, 900u, 6000u}) {
        double square = 0, largest = 0;
        std::size_t places = 0;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const AxisDensity density(uniform_axes(count, seed));
            const double deviation = density.uniform_deviation();
            for (const SpaceDirection& place : uniform_axes(400, 1000 + seed)) {
                const double difference = (density.at(place) - 1) / deviation;
                square += difference * difference;
                largest = std::max(largest, std::abs(difference));
                ++places;
            }
        }
        // The places of one sample are correlated: of 30 axes a few dozen count as independent.
        EXPECT_NEAR(std::sqrt(square / static_cast<double>(places)), 1, count < 100 ? 0.25 : 0.1) << count;
        EXPECT_LT(largest, 6) << count;
    }
    EXPECT_NEAR(AxisDensity(uniform_axes(900, 1)).uniform_deviation(), 1.0 / 3, 1e-12);
    EXPECT_LT(AxisDensity(uniform_axes(6000, 1)).uniform_deviation(), 0.21);
}

TEST(AxisDensity, PeaksAtTheMeanOfACluster) {
    // The mean of 400 axes errs by 1 / sqrt(400 x 50) = 0.4 deg; the densest place errs more.
    for (const double angle : {20.0, 60.0, 88.0}) {
        const AxisDensity::Peak peak = AxisDensity(cluster(400, 50, angle * degree, 1)).peak();
        EXPECT_GT(std::abs(dot(peak.axis, at_angles(angle * degree, 1))), std::cos(2.5 * degree)) << angle;
        EXPECT_GE(peak.axis.down, 0);
        // Fisher's density with K = 50, smoothed by the kernel with k = 2 (1 + 400 / 9): about K k / (K + k).
        EXPECT_NEAR(peak.density, 50 * 90.9 / 140.9, 5) << angle;
    }
    const AxisDensity one(std::vector<SpaceDirection>{at_angles(0.5, 2)});
    EXPECT_NEAR(dot(one.peak().axis, at_angles(0.5, 2)), 1, 1e-15);
    EXPECT_NEAR(one.peak().density, one.at(at_angles(0.5, 2)), 1e-14);
}

TEST(AxisDensity, HasNoSign) {
    const AxisDensity density(cluster(100, 20, 89 * degree, 2));
    for (const double azimuth : {0.1, 2.0, 4.5}) {
        // Across the rim: a line just above the horizontal is the one just below it on the other side.
        const SpaceDirection up = at_angles(91 * degree, azimuth),
                             down = at_angles(89 * degree, azimuth + pi);
        EXPECT_NEAR(density.at(up), density.at(down), 1e-12);
        EXPECT_EQ(density.at(up), density.at({-up.east, -up.north, -up.down}));
    }
    // The sign with which an axis is given does not count.
    std::vector<SpaceDirection> axes = cluster(100, 20, 50 * degree, 2), others = axes;
    for (SpaceDirection& a : others) a = {-a.east, -a.north, -a.down};
    EXPECT_EQ(AxisDensity(axes).at({0, 0, 1}), AxisDensity(others).at({0, 0, 1}));
}

}  // namespace
}  // namespace rockslope::axis_density_test
