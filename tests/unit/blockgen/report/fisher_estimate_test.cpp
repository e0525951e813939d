#include "blockgen/report/fisher_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "blockgen/sampling/random_stream.hpp"

namespace rockslope::blockgen::fisher_estimate_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(FisherEstimate, OfFourPolesRoundTheVertical) {
    // The sum of four poles at the angle a to the vertical is 4 cos a long, so K = 3 / (4 (1 - cos a)).
    for (const double angle : {1.0, 20.0, 40.0}) {
        const double sine = std::sin(angle * degree), cosine = std::cos(angle * degree);
        const std::vector<Pole> poles = {
            {sine, cosine, 0}, {-sine, cosine, 0}, {0, cosine, sine}, {0, cosine, -sine}};
        const FisherEstimate estimate = fisher_estimate(poles);
        EXPECT_EQ(estimate.count, 4u);
        EXPECT_NEAR(estimate.mean.up, 1, 1e-15);
        ASSERT_TRUE(estimate.k);
        EXPECT_NEAR(*estimate.k * 4 * (1 - cosine) / 3, 1, 1e-10) << angle;
    }
}

TEST(FisherEstimate, TakesPolesWithoutASign) {
    // Planes that dip by 85 degrees to the east and to the west have upward poles on opposite sides.
    const double sine = std::sin(85 * degree), cosine = std::cos(85 * degree);
    const FisherEstimate estimate = fisher_estimate(std::vector<Pole>{{sine, cosine, 0}, {-sine, cosine, 0}});
    EXPECT_NEAR(std::abs(estimate.mean.x), 1, 1e-14);
    ASSERT_TRUE(estimate.k);
    EXPECT_NEAR(*estimate.k, 1 / (2 * (1 - std::cos(5 * degree))), 1e-9);
}

TEST(FisherEstimate, HasNoConcentrationWithoutScatter) {
    const Pole pole = pole_of(60 * degree, 120 * degree, 0);
    for (const std::size_t n : {1u, 2u, 1000u}) {
        const FisherEstimate estimate = fisher_estimate(std::vector<Pole>(n, pole));
        EXPECT_FALSE(estimate.k) << n;
        EXPECT_NEAR(estimate.mean.x, pole.x, 1e-14);
        EXPECT_NEAR(estimate.mean.out, pole.out, 1e-14);
    }
}

TEST(FisherEstimate, FindsTheLawThatPolesWereDrawnFrom) {
    // 2 K (n - R) follows the chi-squared law of 2 (n - 1) degrees of freedom for large K, so that the
    // estimate has the mean K (n - 1) / (n - 2) and the standard deviation K / sqrt(n - 2). The mean of 200
    // samples lies within three standard deviations, 2.2 % of K, with 0.5 % for the curvature at K = 20.
    constexpr int samples = 200, n = 100;
    for (const double k : {20.0, 200.0}) {
        const Orientation law{{}, {pole_of(50 * degree, 230 * degree, 0)}, k};
        double sum = 0, turn = 0;
        for (int sample = 0; sample < samples; ++sample) {
            const RandomStream draws(static_cast<std::uint64_t>(sample), "fisher");
            std::vector<Pole> poles;
            for (int i = 0; i < n; ++i)
                poles.push_back(law.draw_pole(draws.draw(0, i, 0), draws.draw(0, i, 1)));
            const FisherEstimate estimate = fisher_estimate(poles);
            ASSERT_TRUE(estimate.k);
            sum += *estimate.k;
            turn = std::max(turn,
                            std::acos(estimate.mean.x * law.poles[0].x + estimate.mean.up * law.poles[0].up +
                                      estimate.mean.out * law.poles[0].out));
        }
        EXPECT_NEAR(sum / samples / k, 99.0 / 98, 0.027) << k;
        // K n times the square of the mean's error is chi-squared of two degrees: beyond 28 once in 1e6.
        EXPECT_LT(turn, std::sqrt(28 / (k * n))) << k;
    }
}

}  // namespace
}  // namespace rockslope::blockgen::fisher_estimate_test
