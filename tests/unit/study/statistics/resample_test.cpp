#include "study/statistics/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "study/statistics/fit_demands.hpp"
#include "study/statistics/fit_outcomes.hpp"

namespace rockslope::resample_test {
namespace {

using namespace study;

constexpr double intercept = -0.44, slope = 2.4, sigma = 0.45, limit = 0.05;
const double true_median = std::exp((std::log(limit) - intercept) / slope);
constexpr double true_dispersion = sigma / slope;

/// Demands ln D = a + b ln IM + sigma e of `rows` rows; with a share of the variance common to a record.
std::vector<Demand> demands_of(std::uint64_t seed, int rows, int records, double common) {
    std::mt19937_64 generator(seed);
    const auto unit = [&] { return (static_cast<double>(generator() >> 11u) + 0.5) * 0x1p-53; };
    std::vector<double> of_record;
    for (int k = 0; k < records; ++k) of_record.push_back(normal_quantile(unit()));
    std::vector<Demand> demands;
    for (int k = 0; k < rows; ++k) {
        const double intensity = 0.05 * std::pow(20, unit());
        const double error = std::sqrt(common) * of_record[static_cast<std::size_t>(k % records)] +
                             std::sqrt(1 - common) * normal_quantile(unit());
        demands.push_back({intensity, std::exp(intercept + slope * std::log(intensity) + sigma * error)});
    }
    return demands;
}

WeightedFit fit_of(std::vector<Demand>& demands) {
    return [&demands](std::span<const double> weights) {
        for (std::size_t k = 0; k < demands.size(); ++k) demands[k].weight = weights[k];
        const auto fit = fit_demands(demands);
        return fit ? fit->curve(limit) : std::nullopt;
    };
}

/// How many of the bands of many data sets hold the true median and the true dispersion, at the confidence
/// that the bands have and, by the quantile alone, at others.
struct Coverage {
    int sets = 0, median = 0, dispersion = 0;
    int median_of_90 = 0, dispersion_of_90 = 0;  ///< of bands of 90 %
    int median_of_99 = 0, dispersion_of_99 = 0;

    void add(CurveBand band) {
        ++sets;
        const double of_95 = normal_quantile(0.975), quantile = band.quantile;
        const auto holds = [&](double level, int& of_median, int& of_dispersion) {
            band.quantile = quantile * normal_quantile(level) / of_95;
            if (std::abs(std::log(band.curve.median / true_median)) <= std::log(band.median_factor()))
                ++of_median;
            if (std::abs(std::log(band.curve.dispersion / true_dispersion)) <=
                std::log(band.dispersion_factor()))
                ++of_dispersion;
        };
        holds(0.975, median, dispersion);
        holds(0.95, median_of_90, dispersion_of_90);
        holds(0.995, median_of_99, dispersion_of_99);
    }
    static double percent(int count, int of) { return 100.0 * count / of; }
    std::string text() const {
        const auto all = {median, dispersion, median_of_90, dispersion_of_90, median_of_99, dispersion_of_99};
        std::string text;
        for (const int count : all) text += std::to_string(percent(count, sets)) + " ";
        return text;
    }
};

bool is_near_95(int count, int sets) {
    return Coverage::percent(count, sets) >= 93 && Coverage::percent(count, sets) <= 97;
}

/// Requires that 93 to 97 per cent of the bands hold the truth, and that bands of 90 % or 99 % in their place
/// would be found wrong.
void expect_95(const Coverage& coverage) {
    SCOPED_TRACE(coverage.text());
    for (const int count : {coverage.median, coverage.dispersion})
        EXPECT_TRUE(is_near_95(count, coverage.sets)) << count;
    for (const int count :
         {coverage.median_of_90, coverage.dispersion_of_90, coverage.median_of_99, coverage.dispersion_of_99})
        EXPECT_FALSE(is_near_95(count, coverage.sets)) << count;
}

// The true median and dispersion lie in the 95 % band in 93 to 97 of 100 data sets of 400 independent rows.
// Of 2000 sets they did in 94.8 and 94.5 %.
TEST(Resample, BandsOfIndependentRowsHaveTheirConfidence) {
    Coverage coverage;
    for (int seed = 1; seed <= 400; ++seed) {
        std::vector<Demand> demands = demands_of(static_cast<std::uint64_t>(seed), 400, 1, 0);
        const auto band = bootstrap(fit_of(demands), demands.size(), {},
                                    {.samples = 200, .seed = static_cast<std::uint64_t>(seed)});
        coverage.add(*band);
    }
    expect_95(coverage);
}

/// Rows of stripes: whether the demands of 50 rows at each of 8 intensities pass the limit.
struct Stripes {
    std::vector<double> intensities;  ///< of the stripes
    std::vector<std::size_t> stripe;  ///< of each row
    std::vector<bool> has_failed;     ///< of each row
};

Stripes stripes_of(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const LognormalCurve truth{true_median, true_dispersion};
    Stripes stripes;
    for (std::size_t k = 0; k < 8; ++k) {
        stripes.intensities.push_back(true_median *
                                      std::exp((static_cast<double>(k) - 3.5) / 2 * true_dispersion));
        for (int row = 0; row < 50; ++row) {
            const double unit = (static_cast<double>(generator() >> 11u) + 0.5) * 0x1p-53;
            stripes.stripe.push_back(k);
            stripes.has_failed.push_back(unit < truth.probability(stripes.intensities[k]));
        }
    }
    return stripes;
}

WeightedFit fit_of(const Stripes& stripes) {
    return [&stripes](std::span<const double> weights) -> std::optional<LognormalCurve> {
        std::vector<Outcome> outcomes;
        for (const double intensity : stripes.intensities) outcomes.push_back({intensity, 0, 0});
        for (std::size_t row = 0; row < weights.size(); ++row) {
            Outcome& outcome = outcomes[stripes.stripe[row]];
            (stripes.has_failed[row] ? outcome.failed : outcome.safe) += weights[row];
        }
        const OutcomeFit fit = fit_outcomes(outcomes);
        return fit.kind == FitKind::curve ? std::optional(fit.curve) : std::nullopt;
    };
}

// The same of curves that are fitted to outcomes: of 2000 sets 94.9 and 94.9 %.
TEST(Resample, BandsOfOutcomesHaveTheirConfidence) {
    Coverage coverage;
    for (int seed = 1; seed <= 400; ++seed) {
        const Stripes stripes = stripes_of(static_cast<std::uint64_t>(seed));
        const auto band = bootstrap(fit_of(stripes), stripes.stripe.size(), {},
                                    {.samples = 200, .seed = static_cast<std::uint64_t>(seed)});
        coverage.add(*band);
    }
    expect_95(coverage);
}

/// Bands of rows that share half of their variance with the others of their record, over rows or over
/// records.
Coverage coverage_of_records(int seeds, bool by_record) {
    constexpr int rows = 200, records = 20;
    Grouping grouping{"record", {}, records};
    for (int k = 0; k < rows; ++k) grouping.group_of.push_back(k % records);
    Coverage coverage;
    for (int seed = 1; seed <= seeds; ++seed) {
        std::vector<Demand> demands = demands_of(static_cast<std::uint64_t>(seed), rows, records, 0.5);
        coverage.add(*bootstrap(fit_of(demands), demands.size(),
                                by_record ? std::vector{grouping} : std::vector<Grouping>{},
                                {.samples = 200, .seed = static_cast<std::uint64_t>(seed)}));
    }
    return coverage;
}

// Rows of a record belong together: bands over rows are far too narrow. Those over 20 records hold the median
// in 94.8 of 100 sets (of 2000), the dispersion in 90: a scatter that happens to be small makes its band
// narrow as well.
TEST(Resample, BandsOverRecordsKnowThatRowsOfARecordBelongTogether) {
    const Coverage by_rows = coverage_of_records(60, false), by_records = coverage_of_records(400, true);
    EXPECT_LT(Coverage::percent(by_rows.median, by_rows.sets), 75) << "by rows";
    EXPECT_TRUE(is_near_95(by_records.median, by_records.sets)) << by_records.text();
    EXPECT_FALSE(is_near_95(by_records.median_of_90, by_records.sets)) << by_records.text();
    EXPECT_FALSE(is_near_95(by_records.median_of_99, by_records.sets)) << by_records.text();
    EXPECT_GE(Coverage::percent(by_records.dispersion, by_records.sets), 88) << by_records.text();
}

// Where rows are independent, two groupings that cross cost no width: V1 + V2 - V12 is V.
TEST(Resample, CrossedGroupingsOfIndependentRowsGiveTheBandOfRows) {
    std::vector<Demand> demands = demands_of(5, 400, 1, 0);
    Grouping record{"record", {}, 20}, realisation{"realisation", {}, 20};
    for (int k = 0; k < 400; ++k) {
        record.group_of.push_back(k % 20);
        realisation.group_of.push_back(k / 20);
    }
    const auto by_rows = bootstrap(fit_of(demands), 400, {}),
               crossed = bootstrap(fit_of(demands), 400, {record, realisation});
    EXPECT_NEAR(std::sqrt(crossed->median_variance / by_rows->median_variance), 1, 0.35);
    EXPECT_GT(crossed->quantile, by_rows->quantile) << "of 19 degrees of freedom";
}

TEST(Resample, TheBandOfTheCurveIsThatOfTheMedianThere) {
    std::vector<Demand> demands = demands_of(7, 100, 1, 0);
    const auto band = bootstrap(fit_of(demands), 100, {});
    ASSERT_TRUE(band);
    const auto [lower, upper] = band->probability(band->curve.median);
    const double shift = std::log(band->median_factor()) / band->curve.dispersion;
    EXPECT_NEAR(lower, normal_cdf(-shift), 1e-12);
    EXPECT_NEAR(upper, normal_cdf(shift), 1e-12);
    EXPECT_EQ(band->fitted_share, 1);
    EXPECT_EQ(bootstrap(fit_of(demands), 100, {})->median_variance, band->median_variance) << "the same seed";
}

TEST(Resample, GroupsRowsByTheirLabels) {
    const Grouping grouping = group_by("record", std::vector<std::string>{"b", "a", "b", "c"});
    EXPECT_EQ(grouping.group_of, (std::vector<int>{0, 1, 0, 2}));
    EXPECT_EQ(grouping.count, 3);
}

}  // namespace
}  // namespace rockslope::resample_test
