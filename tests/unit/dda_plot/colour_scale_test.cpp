#include "colour_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockslope::colour_scale_test {
namespace {

TEST(ColourScale, CoversTheGivenFractionOfTheArea) {
    const std::vector<DisplacedArea> slope = {{50, 0.02}, {0.5, 40}, {48.5, 0.01}, {1, 0.3}};
    EXPECT_EQ(area_weighted_quantile(slope, 0.99), 0.3)
        << "the small part that moved far is less than 1 % of the area";
    EXPECT_EQ(area_weighted_quantile(slope, 0.98), 0.02);
    EXPECT_EQ(area_weighted_quantile(slope, 1), 40);
    EXPECT_EQ(area_weighted_quantile({{1e-9, 3}}, 0.99), 3);
    EXPECT_EQ(area_weighted_quantile({}, 0.99), 0);
    // For a hundred equal parts the quantile is the 99th, for any rounding of the sums.
    std::vector<DisplacedArea> equal;
    for (int k = 1; k <= 100; ++k) equal.push_back({0.1, static_cast<double>(k)});
    EXPECT_EQ(area_weighted_quantile(equal, 0.99), 99);
}

TEST(ColourScale, RoundsUpToTheNextRoundLength) {
    for (const double exponent : {-9.0, -3.0, 0.0, 4.0}) {
        const double power = std::pow(10, exponent);
        EXPECT_DOUBLE_EQ(round_length_above(1 * power), 1 * power);
        EXPECT_DOUBLE_EQ(round_length_above(1.01 * power), 1.5 * power);
        EXPECT_DOUBLE_EQ(round_length_above(3.7 * power), 4 * power);
        EXPECT_DOUBLE_EQ(round_length_above(8 * power), 8 * power);
        EXPECT_DOUBLE_EQ(round_length_above(8.1 * power), 10 * power);
    }
}

}  // namespace
}  // namespace rockslope::colour_scale_test
