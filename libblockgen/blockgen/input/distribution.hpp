#pragma once

#include <limits>
#include <string>

namespace rockslope::blockgen {

enum class Law { constant, uniform, normal, lognormal, exponential, weibull, gamma, power };

/// A distribution of a length or an angle, truncated to [min, max]. Mean and standard deviation are those of
/// the law before truncation; a uniform law lies between min and max and needs neither, a power law has the
/// density x^-shape between min > 0 and max.
struct Distribution {
    Law law = Law::constant;
    double mean = 0;
    double sd = 0;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    double shape = 1;  ///< Weibull's shape, or the power law's exponent

    /// The value below which lies the share u, in (0, 1), of the truncated distribution.
    double quantile(double u) const;
    /// Mean of the law before truncation; of a power law, which has none, within its bounds.
    double untruncated_mean() const;
    /// Mean of the draws, each counted as no more than `most`, by integration of the quantile.
    double truncated_mean(double most = std::numeric_limits<double>::infinity()) const;
    /// Whether more than 1e-12 of the law lies between min and max, so that quantile() means something.
    bool has_probability_mass() const;
    /// The smallest value that a draw can return.
    double infimum() const;

    friend bool operator==(const Distribution&, const Distribution&) = default;
};

inline Distribution constant_value(double value) {
    return {Law::constant, value, 0, value, value};
}

}  // namespace rockslope::blockgen
