// Changes of a record before it is used as base motion: scale, trim, taper, resample, rotate, correct.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "record/correct.hpp"
#include "record/measures.hpp"
#include "record/resample.hpp"
#include "record/response_spectrum.hpp"
#include "record/rotate.hpp"
#include "record/scale.hpp"
#include "record/trim.hpp"

namespace rockslope::record::change_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A burst of 2 Hz between 5 and 15 s, plus a velocity pulse of 2 s that leaves a permanent displacement of
/// 1 m.
Accelerogram burst(double step = 0.01, double length = 30) {
    Accelerogram record{step, {}};
    for (int k = 0; k * step <= length + 1e-9; ++k) {
        const double t = k * step;
        double a = t > 5 && t < 15
                       ? 3 * std::sin(2 * pi * 2 * (t - 5)) * std::pow(std::sin(pi * (t - 5) / 10), 2)
                       : 0;
        if (t > 8 && t < 10) a += pi / 2 * std::sin(pi * (t - 8));  // v = (1 - cos)/2, u = 1 m
        record.values.push_back(a);
    }
    return record;
}

TEST(Scale, ReachesItsTarget) {
    const Accelerogram record = burst();
    EXPECT_NEAR(measure(scaled_to_peak(record, 2)).peak_acceleration, 2, 1e-12);
    EXPECT_NEAR(measure(scaled_to_arias(record, 1.5)).arias_intensity, 1.5, 1e-12);
    const std::array periods = {0.4};
    EXPECT_NEAR(
        response_spectrum(scaled_to_ordinate(record, 0.4, 0.05, 7), periods, 0.05)[0].absolute_acceleration,
        7, 1e-12);
}

TEST(Scale, RejectsInvalidTargets) {
    for (const double target : {0.0, -1.0, std::nan(""), 1.0 / 0.0}) {
        EXPECT_THROW(scaled_to_peak(burst(), target), std::invalid_argument);
        EXPECT_THROW(scaled_to_arias(burst(), target), std::invalid_argument);
        EXPECT_THROW(scaled_to_ordinate(burst(), 1, 0.05, target), std::invalid_argument);
    }
    EXPECT_THROW(scaled_to_peak({0.01, {0, 0, 0}}, 1), std::invalid_argument);
    EXPECT_THROW(scaled(burst(), std::nan("")), std::invalid_argument);
}

TEST(Trim, KeepsTheSamplesBetweenTwoTimes) {
    const Accelerogram record{0.5, {0, 1, 2, 3, 4, 5}};
    EXPECT_EQ(trimmed(record, 0.5, 1.6).values, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(trimmed(record, 1, 1e9).values, (std::vector<double>{2, 3, 4, 5}));
    EXPECT_THROW(trimmed(record, 1, 1.1), std::invalid_argument);
    EXPECT_THROW(trimmed(record, 9, 10), std::invalid_argument);
    EXPECT_THROW(trimmed(record, -1, 1), std::invalid_argument);
    EXPECT_THROW(trimmed(record, std::nan(""), 1), std::invalid_argument);
}

TEST(Taper, ReducesTheEndsToZeroAndKeepsTheMiddle) {
    const Accelerogram record{0.5, {1, 1, 1, 1, 1, 1, 1}};
    const std::vector<double> expected = {0, 0.5, 1, 1, 1, 0.5, 0};
    const std::vector<double> values = tapered(record, 1).values;
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(values[k], expected[k], 1e-15);
    EXPECT_EQ(tapered(record, 0).values, record.values);
    EXPECT_THROW(tapered(record, 1.6), std::invalid_argument);
    EXPECT_THROW(tapered(record, -1), std::invalid_argument);
}

TEST(Resample, FinerIsLinearAndKeepsTheSamples) {
    const Accelerogram record = burst();
    const Accelerogram fine = resampled(record, 0.0025);
    ASSERT_EQ(fine.values.size(), 4 * (record.values.size() - 1) + 1);
    for (std::size_t k = 0; k < record.values.size(); ++k)
        EXPECT_NEAR(fine.values[4 * k], record.values[k], 1e-12);
    EXPECT_NEAR(measure(fine).final_displacement, measure(record).final_displacement, 1e-9);
}

// 40 Hz at a step of 5 ms would alias to 10 Hz at a step of 20 ms; the component of 2 Hz must stay. Two
// passes of the filter keep (tan(40 pi h) / tan(20 pi h))^-16 = 2.6e-6 of the 40 Hz.
TEST(Resample, CoarserHasNoAliases) {
    Accelerogram clean{0.005, {}};
    Accelerogram record{0.005, {}};
    for (int k = 0; k <= 6000; ++k) {
        const double t = 0.005 * k;
        clean.values.push_back(std::exp(-std::pow((t - 15) / 4, 2)) * std::sin(2 * pi * 2 * t));
        record.values.push_back(clean.values.back() + std::sin(2 * pi * 40 * t));
    }
    const Accelerogram coarse = resampled(record, 0.02);
    for (std::size_t k = 50; k + 50 < coarse.values.size(); ++k)
        EXPECT_NEAR(coarse.values[k], clean.values[4 * k], 1e-5) << k;
    EXPECT_THROW(resampled(record, 0), std::invalid_argument);
    EXPECT_THROW(resampled(record, 31), std::invalid_argument);
    EXPECT_THROW(resampled(record, 1e-12), std::invalid_argument);
    EXPECT_THROW(resampled(record, std::nan("")), std::invalid_argument);
}

// A motion along one azimuth, recorded by two sensors at any angles, is recovered.
TEST(Rotate, GivesTheMotionAlongAnAzimuth) {
    const double motion[] = {0.3, -1.2, 0.7};
    const double heading = 50 * pi / 180;
    for (const double second_azimuth : {90.0, 120.0, 270.0, 45.0}) {
        HorizontalComponent first{{0.01, {}}, 0};
        HorizontalComponent second{{0.01, {}}, second_azimuth};
        for (const double a : motion) {
            first.record.values.push_back(a * std::cos(heading));
            second.record.values.push_back(a * std::cos(heading - second_azimuth * pi / 180));
        }
        const Accelerogram along = rotated(first, second, 50);
        const Accelerogram across = rotated(first, second, 140);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(along.values[k], motion[k], 1e-14);
            EXPECT_NEAR(across.values[k], 0, 1e-14);
        }
        EXPECT_NEAR(rotated(first, second, 0).values[1], first.record.values[1], 1e-14);
    }
}

TEST(Rotate, RejectsNearlyParallelComponents) {
    const Accelerogram record{0.01, {0, 1}};
    EXPECT_THROW(rotated({record, 10}, {record, 15}, 0), std::invalid_argument);
    EXPECT_THROW(rotated({record, 10}, {record, 190}, 0), std::invalid_argument);
    EXPECT_THROW(rotated({record, 0}, {{0.02, {0, 1}}, 90}, 0), std::invalid_argument);
    EXPECT_THROW(rotated({record, 0}, {record, std::nan("")}, 0), std::invalid_argument);
    EXPECT_EQ(rotated({record, 0}, {{0.01, {0, 1, 2}}, 90}, 0).values.size(), 2u);
}

TEST(Correct, SubtractsTheMeanBeforeTheEvent) {
    Accelerogram record = burst();
    for (double& a : record.values) a += 0.05;
    EXPECT_NEAR(measure(without_mean(record, 4)).final_displacement, measure(burst()).final_displacement,
                1e-9);
    EXPECT_THROW(without_mean(record, 31), std::invalid_argument);
    EXPECT_THROW(without_mean(record, -1), std::invalid_argument);
}

// A baseline a0 + a1 t is the derivative of a velocity of degree 2, so the correction removes it completely.
TEST(Correct, SubtractsTheTrendOfTheVelocity) {
    const Accelerogram record = burst();
    Accelerogram drifting = record;
    for (std::size_t k = 0; k < record.values.size(); ++k)
        drifting.values[k] += 0.02 + 1e-3 * static_cast<double>(k) * record.step;
    EXPECT_GT(measure(drifting).final_displacement, 10);
    const Accelerogram plain = without_velocity_trend(record, 2);
    const Accelerogram corrected = without_velocity_trend(drifting, 2);
    for (std::size_t k = 0; k < record.values.size(); ++k)
        EXPECT_NEAR(corrected.values[k], plain.values[k], 1e-6);
    EXPECT_THROW(without_velocity_trend(record, 0), std::invalid_argument);
    EXPECT_THROW(without_velocity_trend({0.01, {0, 1, 2}}, 2), std::invalid_argument);
}

// The usual criterion for a corrected record: final velocity and displacement below 1 % of the peaks.
TEST(Correct, HighPassEndsAtRestWhereItStarted) {
    Accelerogram record = burst();
    for (double& a : record.values) a += 0.01;
    const RecordMeasures measures = measure(high_passed(record, 0.1, 4));
    EXPECT_LT(std::abs(measures.final_velocity), 0.01 * measures.peak_velocity);
    EXPECT_LT(std::abs(measures.final_displacement), 0.01 * measures.peak_displacement);
    EXPECT_NEAR(measures.peak_acceleration, measure(burst()).peak_acceleration, 0.1);
    EXPECT_THROW(high_passed(record, 0, 4), std::invalid_argument);
    EXPECT_THROW(high_passed(record, 1e-9, 4), std::invalid_argument);
}

// A near-source record with a tilting sensor: 0.05 m/s2 during the shaking, 0.01 after it. The permanent
// displacement of 1 m must stay. The correction distributes the tilt evenly over the interval, an error of
// centimetres when the interval is right.
TEST(Correct, NearSourceRecordKeepsItsPermanentDisplacement) {
    Accelerogram record = burst();
    for (std::size_t k = 500; k < record.values.size(); ++k) record.values[k] += k < 1500 ? 0.05 : 0.01;
    EXPECT_GT(measure(record).final_displacement, 10);
    const Accelerogram corrected = correct_baseline_shift(record, 5, 15);
    EXPECT_NEAR(measure(corrected).final_velocity, 0, 1e-12);
    EXPECT_NEAR(measure(corrected).final_displacement, 1, 0.02);
    EXPECT_THROW(correct_baseline_shift(record, 5, 5), std::invalid_argument);
    EXPECT_THROW(correct_baseline_shift(record, 5, 40), std::invalid_argument);
    EXPECT_THROW(correct_baseline_shift(record, std::nan(""), 15), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::record::change_test
