#pragma once

namespace rockslope::study {

/// A fragility curve: P(failure | x) = Phi(ln(x / median) / dispersion).
struct LognormalCurve {
    double median = 0;      ///< intensity at which half fail, in the unit of the intensities
    double dispersion = 0;  ///< standard deviation of the natural logarithm, positive

    /// The probability of failure at an intensity, which is positive.
    double probability(double intensity) const;
};

/// The standard normal distribution function.
double normal_cdf(double z);
/// Its natural logarithm, accurate also where the function itself is zero in double precision.
double log_normal_cdf(double z);
/// The density of the standard normal over its distribution function, phi(z) / Phi(z), for any z.
double inverse_mills_ratio(double z);
/// The quantile of the standard normal, p in (0, 1).
double normal_quantile(double p);

}  // namespace rockslope::study
