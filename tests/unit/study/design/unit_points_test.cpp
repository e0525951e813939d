#include "study/design/unit_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rockslope::unit_points_test {
namespace {

using namespace study;

void expect_in_unit_cube(const UnitPoints& points) {
    for (const auto& point : points)
        for (const double coordinate : point) {
            EXPECT_GE(coordinate, 0);
            EXPECT_LT(coordinate, 1);
        }
}

TEST(UnitPoints, ALatinHypercubeHasOnePointInEachInterval) {
    const UnitPoints points = latin_hypercube_points(17, 3, 5);
    expect_in_unit_cube(points);
    for (std::size_t factor = 0; factor < 3; ++factor) {
        std::set<int> intervals;
        for (const auto& point : points) intervals.insert(static_cast<int>(point[factor] * 17));
        EXPECT_EQ(intervals.size(), 17u);
    }
    EXPECT_NE(points, latin_hypercube_points(17, 3, 6));
    EXPECT_EQ(points, latin_hypercube_points(17, 3, 5));
}

TEST(UnitPoints, SobolsSequenceFillsEveryDyadicInterval) {
    const UnitPoints points = sobol_points(31, 4);
    expect_in_unit_cube(points);
    for (std::size_t factor = 0; factor < 4; ++factor) {
        std::set<int> intervals;
        for (const auto& point : points) intervals.insert(static_cast<int>(point[factor] * 32));
        EXPECT_EQ(intervals.size(), 31u)
            << "of 32 intervals; the first point of the sequence, 0, is left out";
    }
}

TEST(UnitPoints, MoreRowsKeepTheFirstOnes) {
    const UnitPoints few = sobol_points(8, 2), many = sobol_points(20, 2);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
    const UnitPoints drawn = monte_carlo_points(8, 2, 3), more = monte_carlo_points(20, 2, 3);
    EXPECT_TRUE(std::equal(drawn.begin(), drawn.end(), more.begin()));
    expect_in_unit_cube(more);
}

TEST(UnitPoints, ASaltelliDesignExchangesOneColumn) {
    const UnitPoints points = saltelli_points(4, 2);
    ASSERT_EQ(points.size(), 16u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(points[8 + k], (std::vector<double>{points[4 + k][0], points[k][1]}));
        EXPECT_EQ(points[12 + k], (std::vector<double>{points[k][0], points[4 + k][1]}));
    }
}

TEST(UnitPoints, MorrisStepsInOneFactorAtATime) {
    const UnitPoints points = morris_points(5, 4, 3, 2);
    ASSERT_EQ(points.size(), 20u);
    expect_in_unit_cube(points);
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (k % 4 == 0) continue;
        int changed = 0;
        for (std::size_t factor = 0; factor < 3; ++factor) {
            const double step = std::abs(points[k][factor] - points[k - 1][factor]);
            if (step == 0) continue;
            ++changed;
            EXPECT_NEAR(step, 0.5, 1e-12);
        }
        EXPECT_EQ(changed, 1);
    }
}

}  // namespace
}  // namespace rockslope::unit_points_test
