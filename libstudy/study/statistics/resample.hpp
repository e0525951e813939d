#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "study/statistics/lognormal_curve.hpp"

namespace rockslope::study {

/// How rows belong together: rows of one record, or of one realisation, are not independent.
struct Grouping {
    std::string name;           ///< of the factor, for messages
    std::vector<int> group_of;  ///< per row, from 0
    int count = 0;              ///< number of groups
};

/// Fits a curve to rows with weights, one for each row; nothing where they allow none.
using WeightedFit = std::function<std::optional<LognormalCurve>(std::span<const double> weights)>;

/// How well a fitted curve is known.
struct CurveBand {
    LognormalCurve curve;
    /// Covariance of (ln median, ln dispersion).
    double median_variance = 0, dispersion_variance = 0, covariance = 0;
    double quantile = 0;      ///< of Student's t, for both sides together at the band's confidence
    double fitted_share = 0;  ///< of the bootstrap samples, that allowed a curve

    double median_factor() const;      ///< the band of the median: divided and multiplied by it
    double dispersion_factor() const;  ///< the same of the dispersion
    /// The band of the probability of failure at an intensity: {lower, upper}.
    std::pair<double, double> probability(double intensity) const;
};

struct BootstrapOptions {
    int samples = 1000;  ///< for each grouping
    double confidence = 0.95;
    std::uint64_t seed = 1;
};

/// The smallest share of bootstrap samples with a curve for which there is a band.
inline constexpr double least_fitted_share = 0.5;

/// The band of a curve by the bootstrap over whole groups, not over rows: the rows of a group are drawn
/// together. With two groupings (records and realisations) the covariance is V1 + V2 - V12, with V12 that of
/// groups of both [cameron2011], and no less than the larger of V1 and V2; each V is multiplied by G / (G -
/// 1) for its G groups, and the quantile is that of Student's t with one degree of freedom less than the
/// fewest groups. Without a grouping each row is a group.
/// @return nothing where the rows allow no curve, or fewer than least_fitted_share of the samples do.
std::optional<CurveBand> bootstrap(const WeightedFit& fit, std::size_t rows,
                                   const std::vector<Grouping>& groupings,
                                   const BootstrapOptions& options = {});

/// The groups of rows with equal labels, in the order of their first row.
Grouping group_by(const std::string& name, std::span<const std::string> labels);

}  // namespace rockslope::study
