#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace rockslope::blockgen {

/// Kolmogorov-Smirnov distance between a sample and a distribution function.
template <class Cdf>
double ks_distance(std::vector<double> values, const Cdf& cdf) {
    std::sort(values.begin(), values.end());
    double largest = 0;
    const auto n = static_cast<double>(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double f = cdf(values[k]);
        largest = std::max({largest, std::abs(f - static_cast<double>(k) / n),
                            std::abs(f - static_cast<double>(k + 1) / n)});
    }
    return largest;
}

/// The distance that a sample of this size exceeds with probability 1e-3.
inline double ks_limit(std::size_t n) {
    return 1.95 / std::sqrt(static_cast<double>(n));
}

}  // namespace rockslope::blockgen
