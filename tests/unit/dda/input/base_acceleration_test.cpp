#include "dda/input/base_acceleration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/dda/input/small_models.hpp"

namespace rockslope::dda::base_acceleration_test {
namespace {

constexpr double pi = std::numbers::pi;

record::Record sampled(double (*f)(double), record::Quantity quantity, double dt, double duration) {
    record::Record record{dt, {}, quantity};
    for (int i = 0; i * dt <= duration * (1 + 1e-12); ++i) record.values.push_back(f(i * dt));
    return record;
}

double wave(double t) {
    return 0.1 * (1 - std::cos(4 * pi * t));
}
double wave_rate(double t) {
    return 0.4 * pi * std::sin(4 * pi * t);
}
double wave_acceleration(double t) {
    return 1.6 * pi * pi * std::cos(4 * pi * t);
}
double noise(double t) {
    return std::sin(37 * t) + 0.3 * std::sin(11.3 * t + 1) + 0.05;
}

double largest_error(const TimeTable& table, double duration) {
    double error = 0;
    for (double t = 0; t <= duration; t += 1e-3)
        error = std::max(error, std::abs(table.at(t) - wave_acceleration(t)));
    return error;
}

TEST(BaseAcceleration, AnAccelerationIsScaledAndEndsInZero) {
    const TimeTable table = acceleration_of({0.1, {1, -2, 4}, record::Quantity::acceleration}, 0.5, {});
    EXPECT_EQ(table.times().size(), 4u);
    EXPECT_EQ(table.at(0.1), -1);
    EXPECT_EQ(table.at(0.2), 2);
    EXPECT_EQ(table.values().back(), 0) << "a zero is appended one step later";
    EXPECT_DOUBLE_EQ(table.times().back(), 0.3);
}

TEST(BaseAcceleration, SplineDerivativesConverge) {
    // Both accelerations are linear between samples, with an error of h^2/8 times the acceleration's second
    // derivative. The second derivative of the spline itself has an error of h^2/12 times that at the samples
    // (de Boor), its first derivative a smaller one. The last ten samples are left out: there the error of
    // the unknown end slope has not yet decayed.
    for (const double dt : {0.02, 0.01, 0.005}) {
        const TimeTable from_velocity =
            acceleration_of(sampled(wave_rate, record::Quantity::velocity, dt, 2), 1, {});
        const TimeTable from_displacement =
            acceleration_of(sampled(wave, record::Quantity::displacement, dt, 2), 1, {});
        const double scale = 1.6 * pi * pi * 16 * pi * pi * dt * dt;  // amplitude of d2a/dt2, times dt^2
        EXPECT_LT(largest_error(from_velocity, 1.8), 0.25 * scale) << dt;
        EXPECT_LT(largest_error(from_displacement, 1.8), 0.5 * scale) << dt;
    }
}

TEST(BaseAcceleration, TooFewSamplesForASplineAreRefused) {
    const SourceLocation place{"m.toml", 3, 4};
    EXPECT_EQ(io_test::error_of([&] {
                  acceleration_of({0.1, {1, 2, 3, 4}, record::Quantity::velocity}, 1, place);
              }),
              "m.toml:3:4: the record has 4 samples; expected at least 5 to differentiate a velocity");
}

TEST(BaseAcceleration, ACorrectedRecordEndsAtRestWhereItBegan) {
    for (const double step : {0.01, 0.005, 0.0025, 0.02, 0.007}) {
        const TimeTable raw =
            acceleration_of(sampled(noise, record::Quantity::acceleration, 0.01, 20), 1, {});
        const FinalBaseState before = integrate_base_motion(raw, step);
        EXPECT_GT(std::abs(before.displacement), 1) << "the record must drift";
        const TimeTable corrected = baseline_corrected(raw, step);
        const FinalBaseState after = integrate_base_motion(corrected, step);
        // Rounding of 2000 to 8000 sums of terms of order 1 m.
        EXPECT_NEAR(after.velocity, 0, 1e-12) << step;
        EXPECT_NEAR(after.displacement, 0, 1e-11) << step;
        double largest = 0;
        for (std::size_t i = 0; i < raw.values().size(); ++i)
            largest = std::max(largest, std::abs(raw.values()[i] - corrected.values()[i]));
        EXPECT_LT(largest, 0.2) << "the correction is of the order of the mean, 0.05";
        EXPECT_EQ(corrected.values().back(), 0);
    }
}

TEST(BaseAcceleration, TheCorrectionIsAStraightLine) {
    const TimeTable raw = acceleration_of(sampled(noise, record::Quantity::acceleration, 0.01, 5), 1, {});
    const TimeTable corrected = baseline_corrected(raw, 0.01);
    const auto correction = [&](std::size_t i) { return raw.values()[i] - corrected.values()[i]; };
    for (std::size_t i = 1; i + 2 < raw.values().size(); ++i)
        EXPECT_NEAR(correction(i + 1) - 2 * correction(i) + correction(i - 1), 0, 1e-14);
}

TEST(BaseAcceleration, ARecordWithoutDriftIsUnchanged) {
    const TimeTable raw({0, 1, 2}, {0, 0, 0});
    EXPECT_EQ(baseline_corrected(raw, 0.1).values(), raw.values());
}

}  // namespace
}  // namespace rockslope::dda::base_acceleration_test
