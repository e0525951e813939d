#pragma once

#include <optional>
#include <span>

#include "study/statistics/lognormal_curve.hpp"

namespace rockslope::study {

/// What is known of a row's demand.
enum class Known {
    value,     ///< the demand itself
    at_least,  ///< that it is larger: the slope collapsed, and the run ended there
    at_most    ///< that it is smaller: it did not move
};

/// The demand of a row, or a bound of it.
struct Demand {
    double intensity = 0;  ///< positive
    double demand = 0;     ///< positive, in the unit of the limit
    Known known = Known::value;
    double weight = 1;  ///< number of such rows
};

/// ln D = intercept + slope ln x + sigma e, e standard normal.
struct DemandFit {
    double intercept = 0;
    double slope = 0;
    double sigma = 0;            ///< n - 2 in its denominator; with bounds, that of greatest likelihood
    double sigma_likeliest = 0;  ///< of greatest likelihood
    double log_likelihood = 0;   ///< natural, of ln D

    /// P(D > limit | x), which is lognormal in x: median exp((ln limit - intercept) / slope), dispersion
    /// sigma / slope. Nothing where demands do not grow with the intensity.
    std::optional<LognormalCurve> curve(double limit) const;
};

/// Fits ln-demands to ln-intensities: least squares [cornell2002]; where some demands are bounds, maximum
/// likelihood of the censored normal regression [tobin1958], which is concave in (a, b, 1) / sigma
/// [olsen1978]. Nothing with fewer than three demands known, with one intensity, or without scatter.
/// @throws std::invalid_argument for an intensity or a demand that is not positive.
std::optional<DemandFit> fit_demands(std::span<const Demand> demands);

}  // namespace rockslope::study
