#include "blockgen/input/distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "blockgen/sampling/random_stream.hpp"
#include "common/base/input_error.hpp"
#include "unit/blockgen/slopes.hpp"
#include "unit/blockgen/statistics.hpp"

namespace rockslope::blockgen::distribution_test {
namespace {

constexpr std::size_t draws = 10000;

std::vector<double> sample(const Distribution& d) {
    const RandomStream stream(1, "test");
    std::vector<double> values;
    for (std::size_t k = 0; k < draws; ++k) values.push_back(d.quantile(stream.draw(0, 0, k)));
    return values;
}

Distribution weibull(double mean, double shape) {
    Distribution d{Law::weibull, mean};
    d.shape = shape;
    return d;
}

Distribution power(double exponent, double min, double max) {
    Distribution d{Law::power, 0, 0, min, max};
    d.shape = exponent;
    return d;
}

TEST(Distribution, Weibull) {
    const double scale = 3 / std::tgamma(1 + 1 / 1.7);
    EXPECT_LT(ks_distance(sample(weibull(3, 1.7)),
                          [&](double x) { return 1 - std::exp(-std::pow(x / scale, 1.7)); }),
              ks_limit(draws));
    EXPECT_NEAR(weibull(3, 1.7).truncated_mean(), 3, 1e-6);
    // Shape 1 gives the exponential law.
    EXPECT_NEAR(weibull(5, 1).quantile(0.3), Distribution({Law::exponential, 5}).quantile(0.3), 1e-12);
}

TEST(Distribution, GammaOfWholeShapeIsASumOfExponentials) {
    // Shape 4, scale 0.5: P(x) = 1 - exp(-y) (1 + y + y^2/2 + y^3/6), y = x / 0.5.
    const Distribution d{Law::gamma, 2, 1};
    EXPECT_LT(ks_distance(sample(d),
                          [](double x) {
                              const double y = 2 * x;
                              return 1 - std::exp(-y) * (1 + y + y * y / 2 + y * y * y / 6);
                          }),
              ks_limit(draws));
    EXPECT_NEAR(d.truncated_mean(), 2, 1e-6);
}

TEST(Distribution, GammaHasAQuantileInAllItsRange) {
    for (const double sd : {1e-3, 0.01, 0.3, 5.0, 30.0}) {
        const Distribution d{Law::gamma, 1, sd};
        double last = 0;
        for (const double u : {0x1p-53, 1e-6, 0.1, 0.5, 0.9, 1 - 1e-6, 1 - 0x1p-53}) {
            EXPECT_GE(d.quantile(u), last) << sd << ' ' << u;
            last = d.quantile(u);
        }
        EXPECT_NEAR(d.truncated_mean(), 1, 1e-3) << sd;
        const Distribution truncated{Law::gamma, 1, sd, 1, 1.001};
        EXPECT_GE(truncated.quantile(0.5), 1);
        EXPECT_LE(truncated.quantile(0.5), 1.001);
    }
}

TEST(Distribution, PowerLaw) {
    for (const double a : {0.0, 1.0, 2.0, 2.5, 4.0}) {
        const Distribution d = power(a, 0.5, 20);
        const auto integral = [&](double x) {
            return a == 1 ? std::log(x / 0.5) : (std::pow(x, 1 - a) - std::pow(0.5, 1 - a)) / (1 - a);
        };
        EXPECT_LT(ks_distance(sample(d), [&](double x) { return integral(x) / integral(20); }),
                  ks_limit(draws))
            << a;
        const double first_moment =
            a == 2 ? std::log(40) : (std::pow(20, 2 - a) - std::pow(0.5, 2 - a)) / (2 - a);
        EXPECT_NEAR(d.truncated_mean(), first_moment / integral(20), 1e-9) << a;
    }
}

TEST(Distribution, TruncatedWeibullAndGammaKeepTheirShapeWithin) {
    Distribution w = weibull(3, 1.7);
    w.min = 2, w.max = 4;
    const double scale = 3 / std::tgamma(1 + 1 / 1.7);
    const auto cdf = [&](double x) { return 1 - std::exp(-std::pow(x / scale, 1.7)); };
    EXPECT_LT(ks_distance(sample(w), [&](double x) { return (cdf(x) - cdf(2)) / (cdf(4) - cdf(2)); }),
              ks_limit(draws));
    Distribution g{Law::gamma, 2, 1, 1, 3};
    for (const double x : sample(g)) EXPECT_TRUE(x >= 1 && x <= 3);
}

TEST(Distribution, MeanOfTheDraws) {
    EXPECT_EQ(constant_value(4).truncated_mean(), 4);
    EXPECT_NEAR(Distribution({Law::exponential, 20}).truncated_mean(), 20, 1e-5);
    EXPECT_NEAR(Distribution({Law::normal, 10, 2}).truncated_mean(), 10, 1e-9);
    EXPECT_NEAR(Distribution({Law::lognormal, 3, 0.6}).truncated_mean(), 3, 1e-6);
    // Between 5 and 30 an exponential law of mean 20 has the mean 20 + (5 p - 30 q) / (p - q).
    const double p = std::exp(-0.25), q = std::exp(-1.5);
    EXPECT_NEAR(Distribution({Law::exponential, 20, 0, 5, 30}).truncated_mean(),
                20 + (5 * p - 30 * q) / (p - q), 1e-9);
}

// The integral of 1 - F(x) from 0 to the cap, but for rounding: the share below the cap is exact to 2^-52.
TEST(Distribution, MeanOfDrawsUpToACap) {
    const Distribution lognormal{Law::lognormal, 3, 0.6};
    const double sd = std::sqrt(std::log1p(0.04)), log_mean = std::log(3) - sd * sd / 2;
    const auto normal_cdf = [](double z) { return std::erfc(-z / std::sqrt(2)) / 2; };
    for (const double cap : {0.5, 1.0, 2.5, 3.0, 20.0, 50.0, 2000.0}) {
        EXPECT_NEAR(Distribution({Law::exponential, 20}).truncated_mean(cap), -20 * std::expm1(-cap / 20),
                    1e-11 * cap)
            << cap;
        const double z = (std::log(cap) - log_mean) / sd;
        EXPECT_NEAR(lognormal.truncated_mean(cap), 3 * normal_cdf(z - sd) + cap * (1 - normal_cdf(z)),
                    1e-11 * cap)
            << cap;
        const double within = std::min(cap, 3.0), above = std::max(within - 1, 0.0);
        EXPECT_NEAR(Distribution({Law::uniform, 0, 0, 1, 3}).truncated_mean(cap), within - above * above / 4,
                    1e-11 * cap)
            << cap;
        EXPECT_EQ(constant_value(4).truncated_mean(cap), std::min(4.0, cap));
        EXPECT_EQ(Distribution({Law::normal, 4, 0}).truncated_mean(cap), std::min(4.0, cap));
    }
}

TEST(Distribution, KeysOfTheModelFile) {
    const std::string head =
        "[domain]\noutline = [[0, 0], [20, 0], [20, 10], [0, 10]]\nblock_material = \"rock\"\n"
        "[[joint_set]]\nname = \"a\"\nangle = \"0 deg\"\nspacing = ";
    EXPECT_EQ(slope(head + "{ law = \"weibull\", mean = 2, shape = 1.5 }\n").joint_sets[0].spacing,
              weibull(2, 1.5));
    EXPECT_EQ(slope(head + "{ law = \"gamma\", mean = 2, sd = 1 }\n").joint_sets[0].spacing,
              (Distribution{Law::gamma, 2, 1}));
    EXPECT_EQ(slope(head + "{ law = \"power\", exponent = 2, min = 1, max = 9 }\n").joint_sets[0].spacing,
              power(2, 1, 9));
    for (const char* bad :
         {"{ law = \"weibull\", mean = 2 }", "{ law = \"weibull\", mean = 2, shape = 0 }",
          "{ law = \"weibull\", mean = -2, shape = 1 }", "{ law = \"gamma\", mean = 0, sd = 1 }",
          "{ law = \"gamma\", mean = 2 }", "{ law = \"gamma\", mean = 2, sd = 1e-4 }",
          "{ law = \"gamma\", mean = 2, sd = 100 }", "{ law = \"power\", exponent = 2, min = 0, max = 9 }",
          "{ law = \"power\", exponent = 2, min = 1 }", "{ law = \"power\", exponent = 2, min = 3, max = 1 }",
          "{ law = \"power\", exponent = 200, min = 1, max = 2 }", "{ law = \"levy\", mean = 1 }"})
        EXPECT_THROW(slope(head + bad + "\n"), InputError) << bad;
}

}  // namespace
}  // namespace rockslope::blockgen::distribution_test
