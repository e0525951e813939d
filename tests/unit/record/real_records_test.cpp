#include "support/external_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "record/records.hpp"
#include "support/case_name.hpp"

namespace rockslope::record::real_records_test {
namespace {

constexpr double g = 9.80665;
constexpr Quantity acceleration = Quantity::acceleration, velocity = Quantity::velocity,
                   displacement = Quantity::displacement;

struct Expected {
    const char* file;
    std::size_t count;
    double dt;    // s
    double peak;  // in the file's unit
    double unit;  // SI
    Quantity quantity = acceleration;
    std::optional<double> peak_time = {};  // s from the first sample
    double rounding = 0;                   // half a unit of the last digit of the published peak
    const char* declared_unit = "";
};

std::string test_name(const ::testing::TestParamInfo<Expected>& tested) {
    return case_name(std::string(tested.param.file) + "_" + quantity_name(tested.param.quantity));
}

/// The values in the published descriptions of the records.
class RealRecords : public ::testing::TestWithParam<Expected> {};

TEST_P(RealRecords, HaveTheirPublishedPeak) {
    const auto folder = external_data("records");
    if (!folder) GTEST_SKIP() << external_data_missing("records");
    const Expected& expected = GetParam();
    const Record record = read_record(*folder / expected.file, {expected.quantity, expected.declared_unit});
    EXPECT_EQ(record.values.size(), expected.count);
    EXPECT_EQ(record.dt, expected.dt);
    EXPECT_EQ(record.quantity, expected.quantity);
    const auto largest = std::max_element(record.values.begin(), record.values.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    EXPECT_NEAR(*largest / expected.unit, expected.peak, 1e-6 * std::abs(expected.peak) + expected.rounding);
    if (expected.peak_time) {
        EXPECT_NEAR(static_cast<double>(largest - record.values.begin()) * record.dt, *expected.peak_time,
                    1.01 * record.dt);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Peer, RealRecords,
    ::testing::Values(Expected{"RSN763_LOMAP_GIL067.AT2", 7999, 0.005, -0.3585328, g, acceleration, 3.365},
                      Expected{"IELC180.AT2", 4000, 0.01, -0.3128806, g, acceleration, 2.150},
                      Expected{"IELC180.DT2", 4000, 0.01, 13.3061, 0.01, displacement, 4.160},
                      Expected{"NIS090.AT2", 4096, 0.01, -0.5027490, g, acceleration, 7.090}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Networks, RealRecords,
    ::testing::Values(
        Expected{"AOM0041801241951.EW", 9700, 0.01, 0.119710, 1, acceleration, std::nullopt, 5e-7},
        Expected{"AICH040010061330.EW2", 28600, 0.005, -0.03896, 1, acceleration, std::nullopt, 5e-6},
        Expected{"cosmos12_test.v1", 7000, 0.01, -161.9618, 0.01, acceleration, 27.85},
        Expected{"HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", 19128, 0.005, 0.0030002, 1, acceleration, 20.67,
                 5e-8},
        Expected{"0111a.smc", 6001, 0.005, 1.04410, 1, acceleration, 10.17},
        Expected{"csn_20190706031952.CJ.T001230.HNE.sac", 15001, 0.02, 0.043384, 1, acceleration,
                 std::nullopt, 0, "m/s2"}),
    test_name);

// The header of the GeoNet file counts its times from the trigger, 5 s after the first sample.
INSTANTIATE_TEST_SUITE_P(
    Stacked, RealRecords,
    ::testing::Values(Expected{"dmg_CE36456.V2", 3251, 0.02, -267.957, 0.01, acceleration, 10.94},
                      Expected{"dmg_CE36456.V2", 3251, 0.02, -28.253, 0.01, velocity, 11.10},
                      Expected{"dmg_CE36456.V2", 3251, 0.02, 5.449, 0.01, displacement, 7.66},
                      Expected{"20180212_211557_WPWS_20.V2A", 5800, 0.02, -0.0416, 1, acceleration, 48.68},
                      Expected{"20180212_211557_WPWS_20.V2A", 5800, 0.02, 0.00165, 1, velocity, 48.56, 5e-6},
                      Expected{"20180212_211557_WPWS_20.V2A", 5800, 0.02, 0.000131, 1, displacement, 48.66,
                               5e-7}),
    test_name);

// The peaks are those in the headers of the second channels.
TEST(RealRecords, ReadsSecondChannels) {
    const auto folder = external_data("records");
    if (!folder) GTEST_SKIP() << external_data_missing("records");
    const auto peak = [&](const char* file, int channel) {
        RecordDeclaration declaration;
        declaration.channel = channel;
        double largest = 0;
        for (const double value : read_record(*folder / file, declaration).values)
            largest = std::max(largest, std::abs(value));
        return largest;
    };
    EXPECT_NEAR(peak("dmg_CE36456.V2", 2), 0.94805, 1e-9);
    EXPECT_NEAR(peak("20180212_211557_WPWS_20.V2A", 2), 0.1940, 1e-9);
}

}  // namespace
}  // namespace rockslope::record::real_records_test
