#include "blockgen/input/surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "unit/blockgen/slopes.hpp"

namespace rockslope::blockgen::surface_test {
namespace {

using testing::ElementsAre;

SlopeModel domain(Ring outline, std::vector<Ring> further = {}) {
    SlopeModel model;
    model.outline = std::move(outline);
    model.further_outlines = std::move(further);
    return model;
}

TEST(GroundSurface, IsTheUpperSideOfASlope) {
    EXPECT_THAT(ground_surface(domain({{0, 0}, {120, 0}, {120, 30}, {60, 70}, {0, 70}})),
                ElementsAre(Point{0, 70}, Point{60, 70}, Point{120, 30}));
    EXPECT_THAT(ground_surface(domain({{0, 0}, {4, 0}, {2, 3}})),
                ElementsAre(Point{0, 0}, Point{2, 3}, Point{4, 0}));
}

TEST(GroundSurface, AnOverhangAndAnUprightWallMakeSteps) {
    EXPECT_THAT(ground_surface(domain({{0, 0}, {20, 0}, {20, 5}, {8, 5}, {12, 15}, {0, 15}})),
                ElementsAre(Point{0, 15}, Point{12, 15}, Point{12, 5}, Point{20, 5}));
    EXPECT_THAT(ground_surface(domain({{0, 0}, {20, 0}, {20, 5}, {10, 5}, {10, 15}, {0, 15}})),
                ElementsAre(Point{0, 15}, Point{10, 15}, Point{10, 5}, Point{20, 5}));
}

TEST(GroundSurface, CoversAllPartsOfTheDomain) {
    EXPECT_THAT(ground_surface(domain({{0, 1}, {4, 1}, {4, 3}, {0, 3}}, {{{6, 0}, {9, 0}, {9, 2}, {6, 2}}})),
                ElementsAre(Point{0, 3}, Point{4, 3}, Point{4, 0}, Point{6, 0}, Point{6, 2}, Point{9, 2}));
}

/// The highest crossing of an upright line with a ring.
double highest(const Ring& ring, double x) {
    double y = -1e9;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
        if (std::min(p.x, q.x) < x && x < std::max(p.x, q.x))
            y = std::max(y, p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y));
    }
    return y;
}

TEST(GroundSurface, OfStarsIsTheHighestCrossing) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> length(1, 10);
    for (int round = 0; round < 50; ++round) {
        Ring star;
        for (int k = 0; k < 40; ++k) {
            const double angle = 2 * std::numbers::pi * k / 40, r = length(random);
            star.push_back({r * std::cos(angle), r * std::sin(angle)});
        }
        const HeightLine surface = ground_surface(domain(star));
        ASSERT_FALSE(first_turn_back(surface));
        for (std::size_t k = 0; k + 1 < surface.size(); ++k) {
            const Point &p = surface[k], &q = surface[k + 1];
            if (q.x - p.x < 1e-6) continue;
            for (const double t : {0.25, 0.5, 0.75}) {
                const double x = p.x + t * (q.x - p.x);
                EXPECT_NEAR(p.y + t * (q.y - p.y), highest(star, x), 1e-8);  // slopes below 1e7
            }
        }
    }
}

}  // namespace
}  // namespace rockslope::blockgen::surface_test
