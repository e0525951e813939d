#include "blockgen/input/distribution.hpp"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <functional>
#include <numbers>

namespace rockslope::blockgen {

namespace {

double normal_quantile(double u) {
    return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * u);
}
double normal_cdf(double z) {
    return std::erfc(-z / std::numbers::sqrt2) / 2;
}

/// Standard deviation and mean of ln x for a log-normal x with the given mean and standard deviation.
double log_sd(const Distribution& d) {
    return std::sqrt(std::log1p((d.sd / d.mean) * (d.sd / d.mean)));
}
double log_mean(const Distribution& d) {
    return std::log(d.mean) - log_sd(d) * log_sd(d) / 2;
}

/// Scale of the Weibull law, and shape of the gamma law, for the given mean and standard deviation.
double weibull_scale(const Distribution& d) {
    return d.mean / std::tgamma(1 + 1 / d.shape);
}
double gamma_shape(const Distribution& d) {
    return (d.mean / d.sd) * (d.mean / d.sd);
}

/// The integral of x^(power - 1) from a to b, divided by a^power. For power < 0, b may be infinite.
double power_integral(double power, double a, double b) {
    return power == 0 ? std::log(b / a) : (std::pow(b / a, power) - 1) / power;
}

/// Cumulative distribution function of the untruncated law.
double cdf(const Distribution& d, double x) {
    if (x == std::numeric_limits<double>::infinity()) return 1;
    switch (d.law) {
        case Law::normal:
            return normal_cdf((x - d.mean) / d.sd);
        case Law::lognormal:
            return x > 0 ? normal_cdf((std::log(x) - log_mean(d)) / log_sd(d)) : 0;
        case Law::exponential:
            return x > 0 ? -std::expm1(-x / d.mean) : 0;
        case Law::weibull:
            return x > 0 ? -std::expm1(-std::pow(x / weibull_scale(d), d.shape)) : 0;
        case Law::gamma:
            return x > 0 ? boost::math::gamma_p(gamma_shape(d), x * d.mean / (d.sd * d.sd)) : 0;
        default:
            return 0;
    }
}

/// Whether all draws equal the mean.
bool is_degenerate(const Distribution& d) {
    return d.sd == 0 && (d.law == Law::normal || d.law == Law::lognormal || d.law == Law::gamma);
}

/// The share of the draws below a value, from their quantile function, by bisection.
double share_below(const std::function<double(double)>& quantile, double value) {
    double low = 0, high = 1;
    while (high - low > 0x1p-52) {
        const double middle = (low + high) / 2;
        (quantile(middle) < value ? low : high) = middle;
    }
    return high == 1 ? 1 : low;
}

}  // namespace

double Distribution::untruncated_mean() const {
    if (law == Law::uniform) return (min + max) / 2;
    if (law != Law::power) return mean;
    return min * power_integral(2 - shape, min, max) / power_integral(1 - shape, min, max);
}

double Distribution::truncated_mean(double cap) const {
    if (law == Law::constant) return std::min(mean, cap);
    if (max <= cap && (law == Law::uniform || law == Law::power)) return untruncated_mean();
    // The quantile may be infinite at u = 0 and u = 1, but the integral is finite; the clamp avoids the ends.
    const auto quantile_inside = [this](double u) { return quantile(std::clamp(u, 0x1p-53, 1 - 0x1p-53)); };
    // Integrated up to the kink at the cap: across it the rule would converge slowly.
    const double below = std::isinf(cap) ? 1.0 : share_below(quantile_inside, cap);
    boost::math::quadrature::tanh_sinh<double> rule;
    const double integral = below == 0 ? 0 : rule.integrate(quantile_inside, 0.0, below);
    return below == 1 ? integral : integral + (1 - below) * cap;
}

double Distribution::quantile(double u) const {
    if (law == Law::constant) return mean;
    if (law == Law::uniform) return min + u * (max - min);
    if (law == Law::power) {
        const double power = 1 - shape;
        const double x = power == 0
                             ? min * std::pow(max / min, u)
                             : min * std::pow(1 + u * power * power_integral(power, min, max), 1 / power);
        return std::clamp(x, min, max);
    }
    if (is_degenerate(*this)) return std::clamp(mean, min, max);
    const double low = cdf(*this, min), high = cdf(*this, max);
    const double p = std::min(low + u * (high - low), 1 - 0x1p-53);
    double value = 0;
    if (law == Law::normal) value = mean + sd * normal_quantile(p);
    if (law == Law::lognormal) value = std::exp(log_mean(*this) + log_sd(*this) * normal_quantile(p));
    if (law == Law::exponential) value = -mean * std::log1p(-p);
    if (law == Law::weibull) value = weibull_scale(*this) * std::pow(-std::log1p(-p), 1 / shape);
    if (law == Law::gamma) value = boost::math::gamma_p_inv(gamma_shape(*this), p) * sd * sd / mean;
    return std::clamp(value, min, max);
}

bool Distribution::has_probability_mass() const {
    if (law == Law::constant || law == Law::uniform || law == Law::power) return true;
    if (is_degenerate(*this)) return min <= mean && mean <= max;
    return cdf(*this, max) - cdf(*this, min) > 1e-12;
}

double Distribution::infimum() const {
    if (law == Law::constant) return mean;
    if (law == Law::lognormal || law == Law::exponential || law == Law::weibull || law == Law::gamma)
        return std::max(min, 0.0);
    return min;
}

}  // namespace rockslope::blockgen
