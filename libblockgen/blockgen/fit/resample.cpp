#include "blockgen/fit/resample.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "blockgen/sampling/random_stream.hpp"

namespace rockslope::blockgen {

namespace {

constexpr int resamples = 800;
constexpr double tail = 0.05;
/// With more units the skewness of an estimate moves the ends of its interval by less than a hundredth of it.
constexpr std::size_t max_skewed_units = 200;

/// The Poisson number of mean 1 at a quantile.
int poisson_quantile(double u) {
    double p = std::exp(-1.0), sum = p;
    int k = 0;
    while (u > sum && k < 20) sum += p /= ++k;
    return k;
}

/// The value at a fraction of sorted values, interpolated.
double percentile(const std::vector<double>& sorted, double fraction) {
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// The acceleration of each value: a sixth of the skewness of its changes when a unit is left out.
std::vector<double> accelerations(std::size_t units, const Statistic& statistic,
                                  const std::vector<double>& values) {
    std::vector<double> square(values.size(), 0), cube(values.size(), 0);
    std::vector<double> weights(units, 1);
    for (std::size_t i = 0; i < units; ++i) {
        weights[i] = 0;
        const std::vector<double> without = statistic(weights);
        weights[i] = 1;
        for (std::size_t v = 0; v < values.size(); ++v) {
            const double change = values[v] - without[v];
            if (!std::isfinite(change)) continue;
            square[v] += change * change;
            cube[v] += change * change * change;
        }
    }
    std::vector<double> result;
    for (std::size_t v = 0; v < values.size(); ++v)
        result.push_back(square[v] > 0 ? cube[v] / (6 * std::pow(square[v], 1.5)) : 0);
    return result;
}

/// @param spread sorted values of the resamples. @param reach standard deviations from the value to an end.
Estimate interval(double value, const std::vector<double>& spread, double acceleration, double reach) {
    if (spread.empty()) return {value, value, value};
    const boost::math::normal_distribution<double> normal;
    const auto n = static_cast<double>(spread.size());
    const auto below = std::lower_bound(spread.begin(), spread.end(), value) - spread.begin();
    const auto upto = std::upper_bound(spread.begin(), spread.end(), value) - spread.begin();
    const double share = std::clamp(static_cast<double>(below + upto) / 2 / n, 0.5 / n, 1 - 0.5 / n);
    const double bias = boost::math::quantile(normal, share);
    const auto end = [&](double z) {
        const double shifted = bias + (bias + z) / (1 - acceleration * (bias + z));
        return percentile(spread, boost::math::cdf(normal, shifted));
    };
    return {value, end(-reach), end(reach)};
}

}  // namespace

std::vector<Estimate> resampled(std::size_t units, const Statistic& statistic, std::uint64_t seed,
                                const std::string& name) {
    const std::vector<double> values = statistic(std::vector<double>(units, 1));
    std::vector<std::vector<double>> spread(values.size());
    const RandomStream draws(seed, name);
    std::vector<double> weights(units);
    for (int k = 0; k < resamples; ++k) {
        for (std::size_t i = 0; i < units; ++i) weights[i] = poisson_quantile(draws.draw(0, k, i));
        const std::vector<double> resample = statistic(weights);
        for (std::size_t v = 0; v < values.size(); ++v)
            if (std::isfinite(resample[v])) spread[v].push_back(resample[v]);
    }
    std::vector<double> acceleration(values.size(), 0);
    if (units <= max_skewed_units) acceleration = accelerations(units, statistic, values);
    const double free = std::max(static_cast<double>(units) - 1, 1.0);
    const double reach = std::sqrt((free + 1) / free) *
                         -boost::math::quantile(boost::math::students_t_distribution<double>(free), tail);
    std::vector<Estimate> estimates;
    for (std::size_t v = 0; v < values.size(); ++v) {
        std::sort(spread[v].begin(), spread[v].end());
        estimates.push_back(interval(values[v], spread[v], acceleration[v], reach));
    }
    return estimates;
}

}  // namespace rockslope::blockgen
