#include "record/newmark_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace rockslope::record::newmark_block_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double g = 9.81;

Accelerogram sampled(double length, const std::function<double(double)>& acceleration) {
    Accelerogram record{0.001, {}};
    for (int k = 0; k * 0.001 <= length + 1e-9; ++k) record.values.push_back(acceleration(k * 0.001));
    return record;
}

double radians(double degrees) {
    return degrees * pi / 180;
}

// Closed forms for the half-sine pulse of V13 and the rectangular pulse of V12. The end of the rectangular
// pulse is a ramp over one sample, 1 ms of 0.5 s, which adds half of that to the impulse: 0.3 %.
TEST(NewmarkBlock, AgreesWithClosedForms) {
    const SlidingPlane flat{0, std::atan(0.2)};
    const auto half_sine =
        sampled(1.5, [](double t) { return t <= 0.5 ? 0.5 * g * std::sin(2 * pi * t) : 0; });
    EXPECT_NEAR(newmark_slip(half_sine, flat).back(), -0.28094, 1e-4 * 0.28094 + 5e-6);
    const auto rectangle = sampled(1.5, [](double t) { return t <= 0.5 ? 0.5 * g : 0; });
    EXPECT_NEAR(newmark_slip(rectangle, flat).back(), -0.91969, 0.003 * 0.91969);
}

// V14 and V15: slip after each second. The table has five digits, and linear interpolation over 1 ms has a
// relative error of 2e-6 for a sine of 2 Hz.
TEST(NewmarkBlock, AgreesWithNumericalIntegrationOnInclines) {
    const auto one = newmark_slip(sampled(5, [](double t) { return 0.3 * g * std::sin(2 * pi * t); }),
                                  {radians(20), radians(30)});
    const auto two = newmark_slip(sampled(5, [](double t) { return 0.4 * g * std::sin(4 * pi * t); }),
                                  {radians(10), radians(20)});
    const double expected_one[] = {.06483, .13604, .20726, .27847, .34968};
    const double expected_two[] = {.07481, .15870, .24260, .32649, .41039};
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(one[1000 * (k + 1)], expected_one[k], 2e-5);
        EXPECT_NEAR(two[1000 * (k + 1)], expected_two[k], 2e-5);
    }
}

TEST(NewmarkBlock, BeginsToSlipAtTheYieldCoefficient) {
    const SlidingPlane plane{radians(20), radians(30)};
    EXPECT_NEAR(yield_coefficient(plane), 0.17633, 1e-5);
    const auto slip_at = [&](double factor) {
        return newmark_slip(sampled(1, [&](double) { return -factor * yield_coefficient(plane) * g; }), plane)
            .back();
    };
    EXPECT_EQ(slip_at(0.999), 0);
    EXPECT_GT(slip_at(1.001), 0);
    EXPECT_THROW(newmark_slip(sampled(1, [](double) { return 0.0; }), {-0.1, 0.5}), std::invalid_argument);
    EXPECT_THROW(newmark_slip(sampled(1, [](double) { return 0.0; }), {0.1, std::nan("")}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::record::newmark_block_test
