#include "study/statistics/fit_outcomes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockslope::fit_outcomes_test {
namespace {

using namespace study;

// Reference: maximum likelihood by an independent optimiser, to six digits.
TEST(FitOutcomes, AgreesWithAnIndependentOptimiserOnStripes) {
    const double intensities[] = {.1, .2, .3, .4, .5, .6, .8, 1.0},
                 failures[] = {0, 1, 6, 13, 21, 27, 36, 39};
    std::vector<Outcome> outcomes;
    for (int k = 0; k < 8; ++k) outcomes.push_back({intensities[k], failures[k], 40 - failures[k]});
    const OutcomeFit fit = fit_outcomes(outcomes);
    ASSERT_EQ(fit.kind, FitKind::curve);
    EXPECT_NEAR(fit.curve.median, 0.477993, 5e-7);
    EXPECT_NEAR(fit.curve.dispersion, 0.420992, 5e-7);
    EXPECT_NEAR(-fit.log_likelihood, 117.741812, 5e-7);
}

TEST(FitOutcomes, AgreesWithAnIndependentOptimiserOnACloud) {
    const double intensities[] = {.05, .08, .11, .15, .18, .22, .25, .31,
                                  .36, .42, .47, .55, .61, .70, .82, .95};
    const int failed[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 1};
    std::vector<Outcome> outcomes;
    for (int k = 0; k < 16; ++k)
        outcomes.push_back({intensities[k], double(failed[k]), double(1 - failed[k])});
    const OutcomeFit fit = fit_outcomes(outcomes);
    EXPECT_NEAR(fit.curve.median, 0.438304, 5e-7);
    EXPECT_NEAR(fit.curve.dispersion, 0.337306, 5e-7);
    EXPECT_NEAR(-fit.log_likelihood, 4.344617, 5e-7);
}

// The maximum does not depend on the unit of the intensity.
TEST(FitOutcomes, ScalesWithTheUnit) {
    std::vector<Outcome> outcomes = {{1, 1, 9}, {2, 5, 5}, {3, 8, 2}};
    const LognormalCurve curve = fit_outcomes(outcomes).curve;
    for (Outcome& outcome : outcomes) outcome.intensity *= 1e-6;
    const LognormalCurve scaled = fit_outcomes(outcomes).curve;
    EXPECT_NEAR(scaled.median, 1e-6 * curve.median, 1e-15);
    EXPECT_NEAR(scaled.dispersion, curve.dispersion, 1e-9);
}

TEST(FitOutcomes, TellsWhereThereIsNoCurve) {
    const auto kind = [](std::vector<Outcome> outcomes) { return fit_outcomes(outcomes).kind; };
    EXPECT_EQ(kind({{1, 0, 5}, {2, 0, 5}}), FitKind::all_safe);
    EXPECT_EQ(kind({{1, 5, 0}, {2, 5, 0}}), FitKind::all_failed);
    EXPECT_EQ(kind({{1, 0, 5}, {2, 5, 0}}), FitKind::separable);
    EXPECT_EQ(kind({{1, 0, 5}, {2, 3, 2}, {3, 5, 0}}), FitKind::separable) << "one intensity with both";
    EXPECT_EQ(kind({{2, 3, 2}}), FitKind::not_increasing) << "one intensity alone";
    EXPECT_EQ(kind({{1, 5, 0}, {2, 0, 5}}), FitKind::not_increasing);
    EXPECT_EQ(kind({{1, 3, 2}, {2, 2, 3}}), FitKind::not_increasing);
    const OutcomeFit fit = fit_outcomes(std::vector<Outcome>{{1, 0, 5}, {1.5, 0, 2}, {2, 5, 0}});
    EXPECT_EQ(fit.highest_safe, 1.5);
    EXPECT_EQ(fit.lowest_failed, 2);
    EXPECT_THROW(fit_outcomes({}), std::invalid_argument);
    EXPECT_THROW(kind({{0, 1, 0}}), std::invalid_argument);
}

// Nearly separable data have a maximum far away, and a small dispersion: no failure below 1, none safe
// above 1.001.
TEST(FitOutcomes, FindsTheMaximumOfNearlySeparableData) {
    const OutcomeFit fit =
        fit_outcomes(std::vector<Outcome>{{0.5, 0, 500}, {1, 1, 9}, {1.001, 9, 1}, {2, 500, 0}});
    ASSERT_EQ(fit.kind, FitKind::curve);
    EXPECT_NEAR(fit.curve.median, 1.0005, 1e-4);
    EXPECT_LT(fit.curve.dispersion, 1e-3);
    EXPECT_NEAR(fit.curve.probability(1), 0.1, 1e-3) << "as observed";
}

TEST(FitOutcomes, BoundsAProbabilityWithoutFailure) {
    EXPECT_NEAR(bound_without_failure(1, 0.95), 0.95, 1e-12);
    EXPECT_NEAR(bound_without_failure(59, 0.95), 1 - std::pow(0.05, 1.0 / 59), 1e-12);
    EXPECT_NEAR(bound_without_failure(1e9, 0.95), -std::log(0.05) / 1e9, 1e-15) << "the rule of three";
}

TEST(LognormalCurve, LogarithmsReachIntoTheTails) {
    for (const double z : {-10.0, -1.0, 0.0, 1.0, 10.0})
        EXPECT_NEAR(log_normal_cdf(z), std::log(normal_cdf(z)), 1e-12);
    EXPECT_NEAR(log_normal_cdf(-20), log_normal_cdf(-20 + 1e-12), 1e-9) << "where the series begins";
    EXPECT_NEAR(log_normal_cdf(-100), -5005.524, 1e-3);
    EXPECT_NEAR(inverse_mills_ratio(-20), inverse_mills_ratio(-20 + 1e-12), 1e-6);
    EXPECT_NEAR(inverse_mills_ratio(-1e6), 1e6, 1e-3);
    EXPECT_NEAR(normal_quantile(normal_cdf(1.3)), 1.3, 1e-12);
}

}  // namespace
}  // namespace rockslope::fit_outcomes_test
