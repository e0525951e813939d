#include "blockgen/input/height_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rockslope::blockgen::height_line_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(HeightLine, IsLevelBeyondItsEndsAndClippedWithinThem) {
    EXPECT_THAT(height_line({{2, 1}, {6, 3}}, 0, 8),
                ElementsAre(Point{0, 1}, Point{2, 1}, Point{6, 3}, Point{8, 3}));
    EXPECT_THAT(height_line({{2, 1}, {6, 3}}, 3, 4), ElementsAre(Point{3, 1.5}, Point{4, 2}));
    EXPECT_THAT(height_line({{-4, 0}, {4, 8}, {12, 0}}, 0, 8),
                ElementsAre(Point{0, 4}, Point{4, 8}, Point{8, 4}));
    EXPECT_THAT(height_line({{5, 7}}, 0, 8), ElementsAre(Point{0, 7}, Point{5, 7}, Point{8, 7}));
    EXPECT_THAT(height_line({{20, 7}}, 0, 8), ElementsAre(Point{0, 7}, Point{8, 7}));
}

TEST(HeightLine, TheLowerOfTwoLinesHasAPointWhereTheyCross) {
    const HeightLine rising = {{0, 0}, {8, 8}}, falling = {{0, 4}, {8, 0}}, level = {{0, 2}, {8, 2}};
    EXPECT_THAT(lower_of(rising, level), ElementsAre(Point{0, 0}, Point{2, 2}, Point{8, 2}));
    EXPECT_THAT(upper_of(rising, level), ElementsAre(Point{0, 2}, Point{2, 2}, Point{8, 8}));
    EXPECT_THAT(lower_of(falling, level), ElementsAre(Point{0, 2}, Point{4, 2}, Point{8, 0}));
    EXPECT_EQ(lower_of(level, level), level);
}

TEST(HeightLine, StepsStayUpright) {
    const HeightLine step = {{0, 5}, {4, 5}, {4, 1}, {8, 1}}, level = {{0, 3}, {8, 3}};
    EXPECT_THAT(lower_of(step, level), ElementsAre(Point{0, 3}, Point{4, 3}, Point{4, 1}, Point{8, 1}));
    EXPECT_THAT(upper_of(level, step), ElementsAre(Point{0, 5}, Point{4, 5}, Point{4, 3}, Point{8, 3}));
    EXPECT_THAT(clamped(step, 2, 4), ElementsAre(Point{0, 4}, Point{4, 4}, Point{4, 2}, Point{8, 2}));
}

/// The height of a line within one of its pieces.
double height_at(const HeightLine& line, double x) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Point &p = line[k], &q = line[k + 1];
        if (p.x < x && x <= q.x) return p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
    }
    ADD_FAILURE() << "no piece at " << x;
    return 0;
}

TEST(HeightLine, RandomLinesAreLowerOrHigherAtEachPlace) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> height(0, 1), place(0, 10);
    for (int round = 0; round < 200; ++round) {
        const auto line = [&] {
            std::vector<Point> points;
            for (double x = height(random); x < 10; x += 2 * height(random)) {
                points.push_back({x, height(random)});
                if (height(random) < 0.3) points.push_back({x, height(random)});
            }
            points.push_back({10, height(random)});
            return height_line(points, 0, 10);
        };
        const HeightLine a = line(), b = line(), low = lower_of(a, b), high = upper_of(a, b);
        EXPECT_FALSE(first_turn_back(low));
        for (int k = 0; k < 20; ++k) {
            const double x = place(random), at_a = height_at(a, x), at_b = height_at(b, x);
            // Interpolation in other intervals: a few roundings of heights below 1, at slopes below 1e6.
            EXPECT_NEAR(height_at(low, x), std::min(at_a, at_b), 1e-9);
            EXPECT_NEAR(height_at(high, x), std::max(at_a, at_b), 1e-9);
        }
        const Rise rise = largest_rise(a, b, 0, 10);
        for (int k = 0; k < 20; ++k) {
            const double x = place(random);
            EXPECT_LE(height_at(a, x) - height_at(b, x), rise.height + 1e-9);
        }
    }
}

TEST(HeightLine, LinesThatTouchEncloseARingWithoutWidthThere) {
    const HeightLine upper = {{0, 3}, {2, 1}, {4, 1}, {6, 3}}, lower = {{0, 0}, {2, 1}, {4, 1}, {6, 0}};
    const Ring ring = ring_between(upper, lower);
    EXPECT_EQ(twice_signed_area(ring), 2 * 3 + 2 * 3);
    EXPECT_THAT(ring_between(upper, upper), IsEmpty());
    EXPECT_EQ(side_of_ring(ring, {1, 1}), 1);
    EXPECT_EQ(side_of_ring(ring, {3, 0.5}), -1);
}

}  // namespace
}  // namespace rockslope::blockgen::height_line_test
