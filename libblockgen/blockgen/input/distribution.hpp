#pragma once

#include <limits>
#include <string>

namespace blockgen {

enum class Law { constant, uniform, normal, lognormal, exponential };

/// A distribution of a length or an angle, truncated to [min, max]. Mean and standard deviation are those of
/// the law before truncation; a uniform law lies between min and max and needs neither.
struct Distribution {
    Law law = Law::constant;
    double mean = 0;
    double sd = 0;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();

    /// The value below which lies the share u, in (0, 1), of the truncated distribution.
    double quantile(double u) const;
    /// Mean of the law before truncation.
    double untruncated_mean() const { return law == Law::uniform ? (min + max) / 2 : mean; }
    /// Whether more than 1e-12 of the law lies between min and max, so that quantile() means something.
    bool has_weight() const;
    /// The smallest value that a draw can return.
    double infimum() const;

    friend bool operator==(const Distribution&, const Distribution&) = default;
};

inline Distribution constant_value(double value) {
    return {Law::constant, value, 0, value, value};
}

}  // namespace blockgen
