#include "study/analysis/fragility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/text.hpp"
#include "support/error_of.hpp"

namespace rockslope::fragility_test {
namespace {

using namespace study;
using ::testing::HasSubstr;

/// Rows of 4 records and 5 realisations at 4 intensities; more fail at higher ones.
TextTable table(double shift = 0) {
    TextTable table{{"row", "record", "realisation", "PGA (g)", "status", "crest (m)"}, {}};
    for (int record = 0; record < 4; ++record)
        for (int realisation = 0; realisation < 5; ++realisation)
            for (int intensity = 1; intensity <= 4; ++intensity) {
                const double noise = 0.4 + 0.2 * ((7 * record + 5 * realisation + 3 * intensity) % 11);
                const double demand = 0.02 * intensity * intensity * noise + shift;
                table.rows.push_back({std::to_string(table.rows.size() + 1), std::to_string(record),
                                      std::to_string(realisation), shortest_text(0.1 * intensity),
                                      "completed", shortest_text(demand)});
            }
    return table;
}

void set(std::vector<std::string>& row, const std::string& status, const std::string& crest) {
    row[4] = status;
    row[5] = crest;
}

FragilityRequest request(double limit) {
    FragilityRequest r;
    r.measure = "crest";
    r.intensity = "PGA";
    r.limit = limit;
    r.groups = {"record", "realisation"};
    r.bootstrap.samples = 50;
    return r;
}

TEST(FragilityStudy, FitsACurveWithItsBandOverTheGroups) {
    const Fragility fragility = fit_fragility(table(), "results.csv", request(0.2));
    ASSERT_TRUE(fragility.curve);
    EXPECT_GT(fragility.curve->median, 0.2);
    EXPECT_LT(fragility.curve->median, 0.4);
    ASSERT_TRUE(fragility.band);
    EXPECT_EQ(fragility.groupings.size(), 2u);
    EXPECT_THAT(fragility_text(fragility), HasSubstr("over 4 groups of record and 5 groups of realisation"));
    const TextTable curve = fragility_table(fragility);
    EXPECT_EQ(curve.heading[0], "PGA (g)");
    for (const auto& row : curve.rows) {
        EXPECT_LE(*parse_number(row[2]), *parse_number(row[1]));
        EXPECT_GE(*parse_number(row[3]), *parse_number(row[1]));
    }
    const TextTable convergence = convergence_table(fragility);
    ASSERT_EQ(convergence.rows.size(), 3u) << "2, 3 and 4 records";
    EXPECT_NEAR(*parse_number(convergence.rows.back()[1]), fragility.curve->median, 1e-12);
}

TEST(FragilityStudy, RowsThatCollapsedHaveFailedWhateverTheirMeasure) {
    TextTable rows = table();
    for (auto& row : rows.rows)
        if (row[3] == "0.4") set(row, "collapsed", "0.001");
    set(rows.rows[0], "failed", "");
    set(rows.rows[7], "not needed", "");
    const Fragility fragility = fit_fragility(rows, "results.csv", request(0.2));
    EXPECT_EQ(fragility.left_out, 1u);
    for (const FragilityPoint& point : fragility.points)
        if (point.intensity == 0.4) {
            EXPECT_TRUE(point.has_failed);
        }
    EXPECT_THAT(fragility_text(fragility), HasSubstr("1 without a result are left out"));
    FragilityRequest demands = request(0.2);
    demands.method = FragilityMethod::demands;
    const Fragility regression = fit_fragility(rows, "results.csv", demands);
    ASSERT_TRUE(regression.demands);
    EXPECT_GT(regression.demands->slope, 0) << "the demand of a collapsed row is at least the limit";
}

TEST(FragilityStudy, GivesABoundWhereThereIsNoCurve) {
    const auto told = [&](double limit, double shift) {
        const Fragility fragility = fit_fragility(table(shift), "results.csv", request(limit));
        EXPECT_FALSE(fragility.curve);
        EXPECT_LE(fragility_table(fragility).rows.size(), 2u);
        return fragility_text(fragility);
    };
    EXPECT_THAT(told(10, 0), HasSubstr("no row failed: the median is above 0.4"));
    EXPECT_THAT(told(0.2, 10), HasSubstr("every row failed: the median is below 0.1"));
    TextTable separable = table();
    for (auto& row : separable.rows) row[5] = std::to_string(*parse_number(row[3]) > 0.25 ? 1 : 0);
    const Fragility fragility = fit_fragility(separable, "results.csv", request(0.5));
    EXPECT_THAT(fragility_text(fragility),
                HasSubstr("separable: none fails below 0.3, none stands above 0.2"));
}

TEST(FragilityStudy, RefusesColumnsThatAreNotThere) {
    FragilityRequest r = request(1);
    r.measure = "crst";
    EXPECT_THAT(error_of([&] { fit_fragility(table(), "t.csv", r); }),
                HasSubstr("t.csv:1: there is no column 'crst'; expected perhaps 'crest'"));
    TextTable waiting = table();
    for (auto& row : waiting.rows) set(row, "waiting", row[5]);
    EXPECT_THAT(error_of([&] { fit_fragility(waiting, "t.csv", request(1)); }),
                HasSubstr("has no row with a result"));
}

}  // namespace
}  // namespace rockslope::fragility_test
