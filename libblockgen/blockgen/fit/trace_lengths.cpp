#include "blockgen/fit/trace_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rockslope::blockgen {

namespace {

double normal_survival(double z) {
    return std::erfc(z / std::numbers::sqrt2) / 2;
}

/// Logarithm of a positive number that may underflow.
double safe_log(double x) {
    return std::log(std::max(x, 1e-300));
}

/// Logarithms of density, survival and integrated survival of a lognormal law, with s2 = ln(1 + sd^2/mean^2)
/// and m = ln mean - s2/2: the integral from l is mean Q((ln l - m - s2)/s) - l Q((ln l - m)/s).
class LognormalTerms {
  public:
    LognormalTerms(double mean, double sd)
        : mean_(mean),
          s2_(std::log1p(sd * sd / (mean * mean))),
          s_(std::sqrt(s2_)),
          log_mean_(std::log(mean)) {}

    double operator()(double length, int ends) const {
        const double x = std::log(length), z = (x - log_mean_ + s2_ / 2) / s_;
        if (ends == 2) return -z * z / 2 - x - std::log(s_) - std::log(2 * std::numbers::pi) / 2;
        if (ends == 1) return safe_log(normal_survival(z));
        return safe_log(mean_ * normal_survival(z - s_) - length * normal_survival(z));
    }

  private:
    double mean_, s2_, s_, log_mean_;
};

double exponential_term(double length, int ends, double mean) {
    return -length / mean + (1 - ends) * std::log(mean);
}

}  // namespace

double mean_trace_length(const std::vector<SeenLength>& seen) {
    double length = 0, ends = 0;
    for (const SeenLength& s : seen) {
        length += s.weight * s.length;
        ends += s.weight * s.ends;
    }
    return ends > 0 ? 2 * length / ends : std::numeric_limits<double>::infinity();
}

double log_likelihood(const std::vector<SeenLength>& seen, const Distribution& law) {
    double sum = 0;
    if (law.law == Law::exponential) {
        for (const SeenLength& s : seen) sum += s.weight * exponential_term(s.length, s.ends, law.mean);
        return sum;
    }
    const LognormalTerms term(law.mean, law.sd);
    for (const SeenLength& s : seen)
        if (s.weight > 0) sum += s.weight * term(s.length, s.ends);
    return sum;
}

double lognormal_sd(const std::vector<SeenLength>& seen, double mean, double near) {
    // Golden section in the logarithm of sd / mean.
    constexpr double shrink = 0.6180339887498949;
    constexpr double least = 0.02, most = 5, factor = 3, precision = 1e-3;
    const auto value = [&](double x) {
        return log_likelihood(seen, {.law = Law::lognormal, .mean = mean, .sd = mean * std::exp(x)});
    };
    double low = std::log(near > 0 ? near / factor : least), high = std::log(near > 0 ? near * factor : most);
    double a = high - shrink * (high - low), b = low + shrink * (high - low);
    double at_a = value(a), at_b = value(b);
    while (high - low > precision) {
        if (at_a > at_b) {
            high = b, b = a, at_b = at_a;
            at_a = value(a = high - shrink * (high - low));
        } else {
            low = a, a = b, at_a = at_b;
            at_b = value(b = low + shrink * (high - low));
        }
    }
    return mean * std::exp((low + high) / 2);
}

Distribution fit_length_law(const std::vector<SeenLength>& seen, double mean) {
    const Distribution exponential{.law = Law::exponential, .mean = mean};
    const Distribution lognormal{.law = Law::lognormal, .mean = mean, .sd = lognormal_sd(seen, mean)};
    return log_likelihood(seen, lognormal) - 1 > log_likelihood(seen, exponential) ? lognormal : exponential;
}

}  // namespace rockslope::blockgen
