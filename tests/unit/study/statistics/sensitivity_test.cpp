#include "study/statistics/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "study/design/unit_points.hpp"

namespace rockslope::sensitivity_test {
namespace {

using namespace study;

/// Ishigami's function of three uniform variables, with a = 7 and b = 0.1 [ishigami1990].
double ishigami(const std::vector<double>& unit) {
    const auto x = [&](int k) { return std::numbers::pi * (2 * unit[static_cast<std::size_t>(k)] - 1); };
    return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

// Closed form: V = 13.8446; first order 0.3139, 0.4424, 0; total 0.5576, 0.4424, 0.2437.
TEST(Sensitivity, FindsTheIndicesOfIshigamisFunction) {
    constexpr int base = 2048;
    const UnitPoints points = saltelli_points(base, 3);
    ASSERT_EQ(points.size(), 5u * base);
    std::vector<std::vector<double>> values(5);
    for (std::size_t k = 0; k < points.size(); ++k) values[k / base].push_back(ishigami(points[k]));
    const auto indices = sobol_indices(values[0], values[1], {values[2], values[3], values[4]});
    const double first[] = {0.3139, 0.4424, 0}, total[] = {0.5576, 0.4424, 0.2437};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(indices[k].first, first[k], 0.02) << k;
        EXPECT_NEAR(indices[k].total, total[k], 0.01) << k;
        EXPECT_GT(indices[k].total_error, 0);
    }
}

// y = 2 x1 + x1 x2 over levels -1 and 1: V = 4 + 1; x1 alone explains 4/5, with the interaction all.
TEST(Sensitivity, FindsTheIndicesOfAFullDesign) {
    const std::vector<std::vector<int>> levels = {{0, 0, 1, 1}, {0, 1, 0, 1}};
    std::vector<double> values;
    for (std::size_t k = 0; k < 4; ++k) {
        const double x1 = 2 * levels[0][k] - 1, x2 = 2 * levels[1][k] - 1;
        values.push_back(2 * x1 + x1 * x2);
    }
    const auto indices = factorial_indices(levels, values);
    EXPECT_NEAR(indices[0].first, 0.8, 1e-12);
    EXPECT_NEAR(indices[0].total, 1, 1e-12);
    EXPECT_NEAR(indices[1].first, 0, 1e-12);
    EXPECT_NEAR(indices[1].total, 0.2, 1e-12);
}

TEST(Sensitivity, AConstantDependsOnNothing) {
    EXPECT_EQ(factorial_indices({{0, 1}}, std::vector<double>{3, 3})[0].total, 0);
    EXPECT_EQ(sobol_indices(std::vector<double>{3, 3}, std::vector<double>{3, 3}, {{3, 3}})[0].first, 0);
}

TEST(Sensitivity, SummarisesElementaryEffects) {
    const auto summary = summarise_effects({{1, -1, 3}, {}});
    EXPECT_NEAR(summary[0].mean_absolute, 5.0 / 3, 1e-12);
    EXPECT_NEAR(summary[0].mean, 1, 1e-12);
    EXPECT_NEAR(summary[0].deviation, 2, 1e-12);
    EXPECT_EQ(summary[1].count, 0);
}

}  // namespace
}  // namespace rockslope::sensitivity_test
