#include "dda/monitor/low_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rockslope::dda::low_pass_test {
namespace {

constexpr double corner = 25;  // Hz

/// Largest filtered value of a sine of unit amplitude, after the first periods.
double gain(double frequency, double step) {
    LowPass filter;
    double largest = 0;
    const int steps = static_cast<int>(20 / (frequency * step));
    for (int k = 1; k <= steps; ++k) {
        const double value =
            filter.pass({std::sin(2 * std::numbers::pi * frequency * k * step), 0}, step, corner).x();
        if (k > steps / 2) largest = std::max(largest, std::abs(value));
    }
    return largest;
}

TEST(LowPass, KeepsSlowMotionAndDampsFast) {
    // The gain of two first-order filters: 1 / (1 + (f / f_c)^2).
    for (const double frequency : {0.5, 2.0, 5.0, 25.0, 100.0})
        EXPECT_NEAR(gain(frequency, 1e-4), 1 / (1 + std::pow(frequency / corner, 2)), 0.02) << frequency;
}

TEST(LowPass, SmoothsASpikeAsItsComment) {
    LowPass filter;
    double largest = filter.pass({100, 0}, 0.005, corner).x();
    for (int k = 0; k < 20; ++k) largest = std::max(largest, filter.pass({0, 0}, 0.005, corner).x());
    EXPECT_NEAR(largest, 30, 5);
    EXPECT_NEAR(gain(5, 0.005), 0.96, 0.01);
}

TEST(LowPass, DoesNotDependOnTheStepForAConstantInput) {
    LowPass coarse, fine;
    coarse.pass({1, -2}, 0.01, corner);
    for (int k = 0; k < 100; ++k) fine.pass({1, -2}, 0.0001, corner);
    EXPECT_NEAR(coarse.first.y(), fine.first.y(), 1e-12);
}

}  // namespace
}  // namespace rockslope::dda::low_pass_test
