#include "blockgen/input/distribution.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace blockgen {

namespace {

double normal_quantile(double u) {
    return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * u);
}
double normal_share(double z) {
    return std::erfc(-z / std::numbers::sqrt2) / 2;
}

/// Standard deviation and mean of ln x for a log-normal x of given mean and standard deviation.
double log_sd(const Distribution& d) {
    return std::sqrt(std::log1p((d.sd / d.mean) * (d.sd / d.mean)));
}
double log_mean(const Distribution& d) {
    return std::log(d.mean) - log_sd(d) * log_sd(d) / 2;
}

/// The share of the untruncated law below x.
double share_below(const Distribution& d, double x) {
    if (x == std::numeric_limits<double>::infinity()) return 1;
    switch (d.law) {
        case Law::normal:
            return normal_share((x - d.mean) / d.sd);
        case Law::lognormal:
            return x > 0 ? normal_share((std::log(x) - log_mean(d)) / log_sd(d)) : 0;
        case Law::exponential:
            return x > 0 ? -std::expm1(-x / d.mean) : 0;
        default:
            return 0;
    }
}

}  // namespace

double Distribution::quantile(double u) const {
    if (law == Law::constant) return mean;
    if (law == Law::uniform) return min + u * (max - min);
    if (sd == 0 && law != Law::exponential) return std::clamp(mean, min, max);
    const double low = share_below(*this, min), high = share_below(*this, max);
    const double share = low + u * (high - low);
    double value = 0;
    if (law == Law::normal) value = mean + sd * normal_quantile(share);
    if (law == Law::lognormal) value = std::exp(log_mean(*this) + log_sd(*this) * normal_quantile(share));
    if (law == Law::exponential) value = -mean * std::log1p(-share);
    return std::clamp(value, min, max);
}

bool Distribution::has_weight() const {
    if (law == Law::constant || law == Law::uniform) return true;
    if (sd == 0 && law != Law::exponential) return min <= mean && mean <= max;
    return share_below(*this, max) - share_below(*this, min) > 1e-12;
}

double Distribution::infimum() const {
    if (law == Law::constant) return mean;
    if (law == Law::lognormal || law == Law::exponential) return std::max(min, 0.0);
    return min;
}

}  // namespace blockgen
