#pragma once

#include <span>

#include "study/statistics/lognormal_curve.hpp"

namespace rockslope::study {

/// Rows of equal intensity, or one row.
struct Outcome {
    double intensity = 0;  ///< positive
    double failed = 0;     ///< number of rows that failed; bootstrap samples have their weights
    double safe = 0;       ///< number of rows that did not
};

/// What the outcomes of a study can tell of a fragility curve.
enum class FitKind {
    curve,          ///< a curve was fitted
    all_safe,       ///< no row failed: the median is above all intensities
    all_failed,     ///< every row failed: the median is below all intensities
    separable,      ///< none fails below an intensity and all above: the dispersion tends to zero
    not_increasing  ///< the rows of higher intensity fail no more often: there is no such curve
};

/// The curve of greatest likelihood, or why there is none.
struct OutcomeFit {
    FitKind kind = FitKind::curve;
    LognormalCurve curve;       ///< of kind `curve`
    double log_likelihood = 0;  ///< natural, of the single outcomes, without binomial coefficients
    double highest_safe = 0;    ///< largest intensity of a row that did not fail; 0: none
    double lowest_failed = 0;   ///< smallest intensity of a row that failed; 0: none
};

/// Fits a curve to outcomes by maximum likelihood of independent failures (Bernoulli), for stripes,
/// incremental analyses and clouds alike [shinozuka2000, baker2015]. With a = -ln(median) / dispersion and b
/// = 1 / dispersion the likelihood of Phi(a + b ln x) is concave, and Newton's method finds its maximum from
/// any start.
/// @throws std::invalid_argument without an outcome, and for an intensity that is not positive.
OutcomeFit fit_outcomes(std::span<const Outcome> outcomes);

/// The upper bound, at this confidence, of a probability of failure of which `rows` independent rows gave
/// none: 1 - (1 - confidence)^(1/rows) (Clopper and Pearson).
double bound_without_failure(double rows, double confidence);

}  // namespace rockslope::study
