#include "record/synthesise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "record/measures.hpp"

namespace rockslope::record::synthesise_test {
namespace {

SyntheticMotion example() {
    SyntheticMotion recipe;
    recipe.envelope = envelope_of_earthquake(6.5, 15);
    return recipe;
}

// The rounding error of the integrals of 4000 samples of order 1 is about 4000 * 1e-16 times their largest
// value.
TEST(Synthesise, StartsAndEndsAtRestWithTheGivenPeak) {
    for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 0xffffffffffffffffULL}) {
        SyntheticMotion recipe = example();
        recipe.seed = seed;
        const Accelerogram record = synthesise(recipe);
        ASSERT_EQ(record.values.size(), 4001u);
        EXPECT_DOUBLE_EQ(record.duration(), 20.0);
        EXPECT_EQ(record.values.front(), 0.0);
        EXPECT_EQ(record.values.back(), 0.0);
        const RecordMeasures measures = measure(record);
        EXPECT_DOUBLE_EQ(measures.peak_acceleration, recipe.peak);
        EXPECT_NEAR(measures.final_velocity, 0, 1e-11);
        EXPECT_NEAR(measures.final_displacement, 0, 1e-10);
    }
}

// The simulator's update must end at rest as well, or a base that follows the record would drift.
TEST(Synthesise, EndsAtRestUnderTheSimulatorsUpdate) {
    const Accelerogram record = synthesise(example());
    double velocity = 0;
    double displacement = 0;
    for (std::size_t k = 1; k < record.values.size(); ++k) {
        displacement += record.step * velocity + record.step * record.step / 2 * record.values[k];
        velocity += record.step * record.values[k];
    }
    EXPECT_NEAR(velocity, 0, 1e-11);
    EXPECT_NEAR(displacement, 0, 1e-10);
}

TEST(Synthesise, DependsOnTheSeedOnly) {
    SyntheticMotion recipe = example();
    const Accelerogram first = synthesise(recipe);
    EXPECT_EQ(first.values, synthesise(recipe).values);
    recipe.seed += 1ULL << 32;
    EXPECT_NE(first.values, synthesise(recipe).values);
}

// With a flat envelope the record is the stationary noise times a scale factor, and its power per band must
// follow the density. The power of a band of 40 to 400 components of random phase is exact over twice the
// duration; over the record its scatter is about 1 / sqrt(components).
TEST(Synthesise, FollowsThePowerSpectrum) {
    SyntheticMotion recipe = example();
    recipe.envelope = {0.005, 20, 0};
    const Accelerogram record = synthesise(recipe);
    const auto band = [&](double low, double high) {
        double measured = 0;
        double expected = 0;
        for (double f = low; f < high; f += 1 / recipe.duration) {
            double cosine = 0;
            double sine = 0;
            for (std::size_t k = 0; k < record.values.size(); ++k) {
                const double angle = 2 * std::numbers::pi * f * record.step * static_cast<double>(k);
                cosine += record.values[k] * std::cos(angle);
                sine += record.values[k] * std::sin(angle);
            }
            measured += cosine * cosine + sine * sine;
            expected += density(recipe.spectrum, f);
        }
        return measured / expected;
    };
    const double reference = band(2, 8);
    EXPECT_NEAR(band(0.5, 2) / reference, 1, 0.35);
    EXPECT_NEAR(band(8, 16) / reference, 1, 0.25);
    EXPECT_NEAR(band(16, 25) / reference, 1, 0.25);
}

TEST(Synthesise, HasDurationAndVelocityOfAnEarthquakeOfItsMagnitude) {
    const RecordMeasures measures = measure(synthesise(example()));
    EXPECT_GT(measures.significant_duration, 5);
    EXPECT_LT(measures.significant_duration, 15);
    // Newmark & Hall (1982): about 0.9 m/s per g on rock; records scatter by a factor of two about it.
    const double velocity_per_g = measures.peak_velocity / (measures.peak_acceleration / 9.80665);
    EXPECT_GT(velocity_per_g, 0.45);
    EXPECT_LT(velocity_per_g, 1.8);
}

TEST(Synthesise, RejectsParametersOutOfRange) {
    const auto expect_rejected = [](auto change) {
        SyntheticMotion recipe = example();
        change(recipe);
        EXPECT_THROW(synthesise(recipe), std::invalid_argument);
    };
    expect_rejected([](auto& recipe) { recipe.step = 0; });
    expect_rejected([](auto& recipe) { recipe.step = std::nan(""); });
    expect_rejected([](auto& recipe) { recipe.duration = 0; });
    expect_rejected([](auto& recipe) { recipe.duration = 20.0025; });
    expect_rejected([](auto& recipe) { recipe.peak = -1; });
    expect_rejected([](auto& recipe) { recipe.peak = std::nan(""); });
    expect_rejected([](auto& recipe) { recipe.envelope.rise = 0; });
    expect_rejected([](auto& recipe) { recipe.spectrum.kappa = -0.1; });
    expect_rejected([](auto& recipe) { recipe.spectrum.ground_frequency = 0; });
    EXPECT_THROW(envelope_of_earthquake(3, 10), std::invalid_argument);
    EXPECT_THROW(envelope_of_earthquake(6, -1), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::record::synthesise_test
