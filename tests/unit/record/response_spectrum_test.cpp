#include "record/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockslope::record::response_spectrum_test {
namespace {

constexpr double pi = std::numbers::pi;

Accelerogram sampled(double step, double duration, double (*acceleration)(double)) {
    Accelerogram record{step, {}};
    for (int k = 0; k * step <= duration; ++k) {
        record.values.push_back(acceleration(k * step));
    }
    return record;
}

// A constant acceleration A from t = 0 on: u = -A / w^2 (1 - e^(-zwt) (cos w_d t + z w / w_d sin w_d t)). The
// method is exact for it, so only rounding is allowed.
TEST(Oscillator, FollowsAConstantAccelerationToRounding) {
    const Accelerogram record = sampled(0.01, 3, [](double) { return 2.0; });
    for (const double damping : {0.0, 0.05, 0.7}) {
        const double w = 2 * pi / 0.4;
        const double wd = w * std::sqrt(1 - damping * damping);
        const OscillatorMotion motion = oscillate(record, 0.4, damping);
        for (std::size_t k = 0; k < record.values.size(); ++k) {
            const double t = 0.01 * static_cast<double>(k);
            const double free =
                std::exp(-damping * w * t) * (std::cos(wd * t) + damping * w / wd * std::sin(wd * t));
            EXPECT_NEAR(motion.displacement[k], -2.0 / (w * w) * (1 - free), 1e-13) << damping << ' ' << k;
        }
    }
}

// A ramp A t on an undamped oscillator: u = -A / w^2 (t - sin(wt) / w), u' = -A / w^2 (1 - cos(wt)).
TEST(Oscillator, FollowsARampToRounding) {
    const Accelerogram record = sampled(0.02, 2, [](double t) { return 3 * t; });
    const double w = 2 * pi / 0.3;
    const OscillatorMotion motion = oscillate(record, 0.3, 0);
    for (std::size_t k = 0; k < record.values.size(); ++k) {
        const double t = 0.02 * static_cast<double>(k);
        EXPECT_NEAR(motion.displacement[k], -3 / (w * w) * (t - std::sin(w * t) / w), 1e-13);
        EXPECT_NEAR(motion.velocity[k], -3 / (w * w) * (1 - std::cos(w * t)), 1e-12);
    }
}

// The steady state under A sin(W t) has the absolute acceleration A sqrt((1 + (2 z r)^2) / ((1 - r^2)^2 + (2
// z r)^2)), r = W / w. Linear interpolation of the sine reduces it by (W dt)^2 / 12 = 8e-6, and the sampling
// of the maxima by (w dt)^2 / 8 = 5e-5.
TEST(ResponseSpectrum, OfALongHarmonicIsItsTransmissibility) {
    const Accelerogram record = sampled(0.001, 40, [](double t) { return 1.5 * std::sin(2 * pi * 1.6 * t); });
    const double damping = 0.05;
    for (const double period : {0.5, 0.625, 1.0}) {
        const double r = 1.6 * period;
        const double damping_term = std::pow(2 * damping * r, 2);
        const double expected = 1.5 * std::sqrt((1 + damping_term) / (std::pow(1 - r * r, 2) + damping_term));
        const OscillatorMotion motion = oscillate(record, period, damping);
        const std::vector<double> last_seconds(motion.absolute_acceleration.end() - 3000,
                                               motion.absolute_acceleration.end());
        EXPECT_NEAR(largest_magnitude(last_seconds), expected, 1e-4 * expected) << period;
    }
}

// Limits: a stiff oscillator moves with the ground (absolute acceleration -> that of the ground), a soft one
// stays at rest (relative displacement -> that of the ground). Two full sines of 1 Hz end at rest after 2 s.
TEST(ResponseSpectrum, HasTheGroundMotionAsItsLimits) {
    Accelerogram record = sampled(0.005, 4, [](double t) { return t <= 2 ? 2 * std::sin(2 * pi * t) : 0.0; });
    const std::array<double, 2> periods = {0.01, 1000};
    const auto spectrum = response_spectrum(record, periods, 0.05);
    // The dynamic amplification at 0.01 s is (T / T_ground)^2 = 1e-4.
    EXPECT_NEAR(spectrum[0].absolute_acceleration, 2.0, 2.0 * 5e-4);
    // At 1000 s the oscillator recovers by about w^2 t^2 / 2 + 2 z w t = 3e-3 in 4 s.
    const double ground = largest_magnitude(integrate(record).displacement);
    EXPECT_NEAR(spectrum[1].displacement, ground, 5e-3 * ground);
}

TEST(ResponseSpectrum, RejectsInvalidPeriodsAndDampings) {
    const Accelerogram record{0.01, {0, 1, 0}};
    for (const double period : {0.0, -1.0, std::nan("")}) {
        EXPECT_THROW(oscillate(record, period, 0.05), std::invalid_argument);
    }
    for (const double damping : {-0.01, 1.0, std::nan("")}) {
        EXPECT_THROW(oscillate(record, 1.0, damping), std::invalid_argument);
    }
}

}  // namespace
}  // namespace rockslope::record::response_spectrum_test
