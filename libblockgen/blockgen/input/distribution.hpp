#pragma once

#include <limits>

namespace rockslope::blockgen {

enum class Law { constant, uniform, normal, lognormal, exponential, weibull, gamma, power };

/// A distribution of a length (m) or an angle (rad), truncated to [min, max]. `mean` and `sd` are the mean
/// and the standard deviation before truncation. The uniform law needs only min and max. The power law has
/// the density x^-shape between min > 0 and max.
struct Distribution {
    Law law = Law::constant;
    double mean = 0;
    double sd = 0;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    double shape = 1;  ///< Weibull shape, or exponent of the power law

    /// Quantile function of the truncated distribution, u in (0, 1).
    double quantile(double u) const;
    /// Mean before truncation. A power law always has bounds: its mean within them.
    double untruncated_mean() const;
    /// Mean of min(x, cap) over the truncated distribution, by integration of the quantile function.
    double truncated_mean(double cap = std::numeric_limits<double>::infinity()) const;
    /// Whether the probability between min and max exceeds 1e-12, so that quantile() is defined.
    bool has_probability_mass() const;
    /// Greatest lower bound of the draws.
    double infimum() const;

    friend bool operator==(const Distribution&, const Distribution&) = default;
};

inline Distribution constant_value(double value) {
    return {Law::constant, value, 0, value, value};
}

}  // namespace rockslope::blockgen
