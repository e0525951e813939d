#include "study/statistics/fit_demands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rockslope::fit_demands_test {
namespace {

using namespace study;

std::vector<Demand> cloud() {
    const double intensities[] = {.05, .08, .11, .15, .18, .22, .25, .31,
                                  .36, .42, .47, .55, .61, .70, .82, .95};
    const double demands[] = {.0008, .0021, .0016, .0049, .012, .0087, .031, .022,
                              .071,  .055,  .13,   .09,   .31,  .26,   .44,  .9};
    std::vector<Demand> list;
    for (int k = 0; k < 16; ++k) list.push_back({intensities[k], demands[k]});
    return list;
}

// Reference: an independent implementation, to six digits.
TEST(FitDemands, AgreesWithAnIndependentRegression) {
    const auto fit = fit_demands(cloud());
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->intercept, -0.444803, 5e-7);
    EXPECT_NEAR(fit->slope, 2.421270, 5e-7);
    EXPECT_NEAR(fit->sigma, 0.445024, 5e-7);
    EXPECT_NEAR(fit->sigma_likeliest, 0.416282, 5e-7);
    EXPECT_NEAR(fit->curve(0.05)->median, 0.348698, 5e-7);
    EXPECT_NEAR(fit->curve(0.05)->dispersion, 0.183798, 5e-7);
}

TEST(FitDemands, AgreesWithAnIndependentOptimiserOnBounds) {
    std::vector<Demand> demands = cloud();
    for (std::size_t k = 14; k < 16; ++k) demands[k] = {demands[k].intensity, 0.4, Known::at_least};
    const auto fit = fit_demands(demands);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->intercept, -0.467044, 5e-7);
    EXPECT_NEAR(fit->slope, 2.408071, 5e-7);
    EXPECT_NEAR(fit->sigma, 0.421098, 5e-7);
    EXPECT_NEAR(-fit->log_likelihood, 8.871503, 5e-7);
}

// Turning the signs of the logarithms turns lower bounds into upper ones.
TEST(FitDemands, UpperBoundsAreLowerBoundsTurnedRound) {
    std::vector<Demand> demands = cloud(), turned;
    demands[15].known = Known::at_least;
    demands[15].demand = 0.4;
    for (const Demand& d : demands)
        turned.push_back(
            {d.intensity, 1 / d.demand, d.known == Known::value ? Known::value : Known::at_most});
    const auto fit = fit_demands(demands), other = fit_demands(turned);
    EXPECT_NEAR(other->slope, -fit->slope, 1e-9);
    EXPECT_NEAR(other->intercept, -fit->intercept, 1e-9);
    EXPECT_NEAR(other->sigma, fit->sigma, 1e-9);
    EXPECT_FALSE(other->curve(0.05)) << "demands that fall with the intensity have no fragility curve";
}

TEST(FitDemands, AWeightOfTwoIsARowTwice) {
    std::vector<Demand> twice = cloud(), weighted = cloud();
    twice.push_back(twice[3]);
    weighted[3].weight = 2;
    EXPECT_NEAR(fit_demands(twice)->slope, fit_demands(weighted)->slope, 1e-12);
    EXPECT_NEAR(fit_demands(twice)->sigma, fit_demands(weighted)->sigma, 1e-12);
}

TEST(FitDemands, GivesNothingWhereThereIsNothing) {
    const auto has_fit = [](std::vector<Demand> demands) { return fit_demands(demands).has_value(); };
    EXPECT_FALSE(has_fit({}));
    EXPECT_FALSE(has_fit({{1, 1}, {2, 3}}));
    EXPECT_FALSE(has_fit({{1, 1}, {1, 3}, {1, 2}})) << "one intensity";
    EXPECT_FALSE(has_fit({{1, 1}, {2, 4}, {4, 16}})) << "no scatter";
    EXPECT_TRUE(has_fit({{1, 1}, {2, 4}, {4, 15}}));
    EXPECT_THROW(has_fit({{0, 1}, {1, 2}, {2, 3}}), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::fit_demands_test
