#include "record/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "record/baseline.hpp"

namespace rockslope::record::measures_test {
namespace {

constexpr double pi = std::numbers::pi;

Accelerogram sine(double amplitude, double frequency, double step, int samples) {
    Accelerogram record{step, {}};
    for (int k = 0; k < samples; ++k) {
        record.values.push_back(amplitude * std::sin(2 * pi * frequency * step * k));
    }
    return record;
}

// A sin(wt) over whole cycles of total length T: v reaches 2 A / w, u drifts by A / w per second, the
// integral of a^2 is A^2 T / 2. Linear interpolation of the sine has a relative error of (w dt)^2 / 12 =
// 3e-6.
TEST(Measures, OfASineAreItsIntegrals) {
    const RecordMeasures measures = measure(sine(3, 1, 0.001, 4001));
    EXPECT_NEAR(measures.peak_acceleration, 3, 1e-12);
    EXPECT_NEAR(measures.peak_velocity, 3 / pi, 1e-5);
    EXPECT_NEAR(measures.final_velocity, 0, 1e-9);
    EXPECT_NEAR(measures.final_displacement, 4 * 3 / (2 * pi), 1e-4);
    EXPECT_NEAR(measures.arias_intensity, pi / (2 * 9.80665) * 9 * 4 / 2, 1e-4);
    EXPECT_NEAR(measures.significant_duration, 0.9 * 4, 0.1);
    EXPECT_NEAR(measures.significant_duration_75, 0.7 * 4, 0.1);
    EXPECT_NEAR(measures.cumulative_absolute_velocity, 3 * 2 / pi * 4, 1e-4) << "the mean of |sin| is 2 / pi";
}

// Two sines of many cycles: the amplitudes' squares are as 4 to 1, so that the mean period is (4 T1 + T2)
// / 5.
TEST(Measures, TheMeanPeriodWeighsPeriodsByTheirPower) {
    Accelerogram record = sine(2, 1, 0.005, 8001);
    const Accelerogram faster = sine(1, 4, 0.005, 8001);
    EXPECT_NEAR(measure(record).mean_period, 1, 0.01);
    for (std::size_t k = 0; k < record.values.size(); ++k) record.values[k] += faster.values[k];
    EXPECT_NEAR(measure(record).mean_period, (4 * 1 + 0.25) / 5, 0.01);
}

// A triangle across zero: the two parts have the areas 0.5 * 0.1 * 0.75 * 3 and 0.5 * 0.1 * 0.25 * 1.
TEST(Measures, TheAbsoluteVelocityIsExactAcrossZero) {
    const RecordMeasures measures = measure({0.1, {3, -1}});
    EXPECT_NEAR(measures.cumulative_absolute_velocity, 0.1 * (0.75 * 3 + 0.25 * 1) / 2, 1e-15);
}

TEST(Measures, OfZeroAccelerationAreZero) {
    for (const Accelerogram& record : {Accelerogram{0.01, {0}}, Accelerogram{0.01, {0, 0, 0}}}) {
        const RecordMeasures measures = measure(record);
        EXPECT_EQ(measures.peak_velocity, 0);
        EXPECT_EQ(measures.arias_intensity, 0);
        EXPECT_EQ(measures.significant_duration, 0);
    }
}

// The sine above drifts by 1.9 m. After the correction it must not drift, and the end samples must be
// unchanged.
TEST(CorrectBaseline, EndsAtRestWhereItStarted) {
    const Accelerogram before = sine(3, 1, 0.01, 401);
    const Accelerogram after = correct_baseline(before);
    const RecordMeasures measures = measure(after);
    EXPECT_NEAR(measures.final_velocity, 0, 1e-13);
    EXPECT_NEAR(measures.final_displacement, 0, 1e-13);
    EXPECT_EQ(after.values.front(), before.values.front());
    EXPECT_EQ(after.values.back(), before.values.back());
}

TEST(CorrectBaseline, IsIdempotent) {
    const Accelerogram once = correct_baseline(sine(3, 1, 0.01, 401));
    const Accelerogram twice = correct_baseline(once);
    for (std::size_t k = 0; k < once.values.size(); ++k) {
        EXPECT_NEAR(twice.values[k], once.values[k], 1e-12);
    }
}

TEST(CorrectBaseline, RejectsTooFewSamples) {
    EXPECT_THROW(correct_baseline({0.01, {}}), std::invalid_argument);
    EXPECT_THROW(correct_baseline({0.01, {0, 1, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::record::measures_test
