#include "blockgen/fit/trace_lengths.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rockslope::blockgen::trace_lengths_test {
namespace {

/// The integral of a function from 0 to a far end, by the trapezoidal rule in the logarithm.
template <class Function>
double integral(const Function& f, double from, double to) {
    constexpr int steps = 20'000;
    double sum = 0;
    for (int k = 0; k <= steps; ++k) {
        const double x = from * std::pow(to / from, static_cast<double>(k) / steps);
        sum += (k == 0 || k == steps ? 0.5 : 1) * x * f(x);
    }
    return sum * std::log(to / from) / steps;
}

// The term of an end that is cut off is the integral of that of an end less, for either law.
TEST(LogLikelihood, TermsAreIntegralsOfEachOther) {
    for (const Distribution& law : {Distribution{.law = Law::exponential, .mean = 3},
                                    Distribution{.law = Law::lognormal, .mean = 3, .sd = 2}}) {
        const auto term = [&](double length, int ends) {
            return std::exp(log_likelihood({{length, ends}}, law));
        };
        EXPECT_NEAR(integral([&](double x) { return term(x, 2); }, 1e-4, 1e3), 1, 1e-4);
        EXPECT_NEAR(integral([&](double x) { return term(x, 1); }, 1e-4, 1e3), 3, 1e-3);
        for (const double length : {0.5, 2.0, 8.0}) {
            EXPECT_NEAR(integral([&](double x) { return term(x, 2); }, length, 1e3), term(length, 1), 1e-5);
            EXPECT_NEAR(integral([&](double x) { return term(x, 1); }, length, 1e3), term(length, 0), 1e-4);
        }
    }
}

TEST(MeanTraceLength, IsTheRatioOfLengthAndEnds) {
    EXPECT_DOUBLE_EQ(mean_trace_length({{2, 2}, {3, 1}, {4, 0}}), 6);
    EXPECT_TRUE(std::isinf(mean_trace_length({{2, 0}})));
}

TEST(FitLengthLaw, TellsALognormalLawFromAnExponentialOne) {
    std::vector<SeenLength> alike, mixed;
    for (int k = 0; k < 200; ++k) {
        alike.push_back({2 + 0.002 * k, 2});
        mixed.push_back({-std::log((k + 0.5) / 200) * 2, 2});
    }
    EXPECT_EQ(fit_length_law(alike, mean_trace_length(alike)).law, Law::lognormal);
    EXPECT_NEAR(fit_length_law(alike, mean_trace_length(alike)).sd, 0.115, 0.01);
    EXPECT_EQ(fit_length_law(mixed, mean_trace_length(mixed)).law, Law::exponential);
}

}  // namespace
}  // namespace rockslope::blockgen::trace_lengths_test
