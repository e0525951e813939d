#include "record/amplification.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "record/response_spectrum.hpp"
#include "record/scale.hpp"
#include "record/synthesise.hpp"
#include "record/wavelets.hpp"

namespace rockslope::record::amplification_test {
namespace {

const std::vector<double> periods = {0.1, 0.2, 0.35, 0.5, 0.8, 1.5};
constexpr std::size_t tenth_second = 0, half_second = 3;  // in the list of periods

TEST(Amplification, OfAScaledRecordIsTheFactor) {
    const Accelerogram base = synthesise({});
    const auto table = amplification(scaled(base, -2.5), base, periods, 0.05);
    ASSERT_EQ(table.size(), periods.size());
    for (const Amplification& a : table) {
        EXPECT_NEAR(a.response_ratio(), 2.5, 1e-12);
        EXPECT_NEAR(a.fourier_ratio, 2.5, 1e-12);
        EXPECT_GT(a.base_response, 0);
    }
}

// The transfer function of an oscillator with a period of 0.5 s is
// |H| = sqrt((1 + 4 z^2 r^2) / ((1 - r^2)^2 + 4 z^2 r^2)), r = f / 2 Hz. The window is a fifteenth of the
// frequency wide. Away from the peak |H| is linear over it to a few per cent, at the peak it is not.
TEST(Amplification, OfAnOscillatorIsItsTransferFunction) {
    const Accelerogram base = synthesise({});
    const double damping = 0.1;
    const Accelerogram floor{base.step, oscillate(base, 0.5, damping).absolute_acceleration};
    Accelerogram quiet = floor;
    quiet.values.resize(2 * quiet.values.size(),
                        0.0);  // zeros after the end, where the oscillator is at rest
    const auto table = amplification(quiet, base, periods, 0.05);
    ASSERT_EQ(table.size(), periods.size());
    for (std::size_t k = 0; k < periods.size(); ++k) {
        const Amplification& a = table[k];
        EXPECT_EQ(a.period, periods[k]);
        const double r = 0.5 / a.period, w = 4 * damping * damping * r * r;
        const double expected = std::sqrt((1 + w) / ((1 - r * r) * (1 - r * r) + w));
        EXPECT_NEAR(a.fourier_ratio, expected, (k == half_second ? 0.12 : 0.06) * expected) << a.period;
    }
}

// A burst at 2 Hz has its largest amplitude at 0.5 s and almost none at 0.1 s.
TEST(Amplification, ReportsWhereTheBaseHardlyMoves) {
    const Accelerogram base = sine_burst(3, 2, 10, 0.005);
    const auto table = amplification(base, base, periods, 0.05);
    ASSERT_EQ(table.size(), periods.size());
    EXPECT_EQ(table[half_second].base_fourier, 1);
    EXPECT_LT(table[tenth_second].base_fourier, 0.01);
    for (const Amplification& a : table) {
        EXPECT_LE(a.base_fourier, 1) << a.period;
        EXPECT_NEAR(a.fourier_ratio, 1, 1e-12) << a.period;
    }
}

TEST(Amplification, RejectsABaseAtRestAndInvalidArguments) {
    const Accelerogram base = synthesise({});
    EXPECT_THROW(amplification(base, scaled(base, 0), periods, 0.05), std::invalid_argument);
    EXPECT_THROW(amplification({0.01, {1}}, base, periods, 0.05), std::invalid_argument);
    EXPECT_THROW(amplification(base, base, periods, 1), std::invalid_argument);
}

}  // namespace
}  // namespace rockslope::record::amplification_test
