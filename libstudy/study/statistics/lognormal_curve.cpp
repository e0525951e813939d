#include "study/statistics/lognormal_curve.hpp"

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace rockslope::study {

namespace {

/// Below this argument the distribution function is taken from its asymptotic series.
constexpr double far_tail = -20;

/// ln of sqrt(2 pi).
const double log_root_two_pi = std::log(2 * std::numbers::pi) / 2;

/// 1 - 1/z2 + 3/z4 - 15/z6 + 105/z8, the factor of phi(z) / -z in Phi(z) far below zero. Its relative error
/// at z = -20 is below 945 / 20^10 = 1e-10.
double tail_series(double z) {
    const double u = 1 / (z * z);
    return 1 - u * (1 - u * (3 - u * (15 - u * 105)));
}

}  // namespace

double normal_cdf(double z) {
    return std::erfc(-z / std::numbers::sqrt2) / 2;
}

double log_normal_cdf(double z) {
    if (z > far_tail) return std::log(normal_cdf(z));
    return -z * z / 2 - log_root_two_pi - std::log(-z) + std::log(tail_series(z));
}

double inverse_mills_ratio(double z) {
    if (z > far_tail) return std::exp(-z * z / 2 - log_root_two_pi) / normal_cdf(z);
    return -z / tail_series(z);
}

double normal_quantile(double p) {
    return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p);
}

double LognormalCurve::probability(double intensity) const {
    return normal_cdf(std::log(intensity / median) / dispersion);
}

}  // namespace rockslope::study
