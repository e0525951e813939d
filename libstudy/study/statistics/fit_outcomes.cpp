#include "study/statistics/fit_outcomes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "study/statistics/maximise.hpp"

namespace rockslope::study {

namespace {

/// The log-likelihood of Phi(a + b u), u the standardised logarithm of the intensity.
LogLikelihood<2> likelihood_at(std::span<const Outcome> outcomes, const Eigen::Vector2d& at, double scale,
                               double centre) {
    LogLikelihood<2> sum;
    for (const Outcome& outcome : outcomes) {
        const Eigen::Vector2d direction(1, (std::log(outcome.intensity) - centre) / scale);
        sum.add_normal(outcome.failed, direction, at);
        sum.add_normal(outcome.safe, -direction, at);
    }
    return sum;
}

/// The range of the intensities of the failed and of the safe rows.
struct Ranges {
    double lowest_failed = std::numeric_limits<double>::infinity(), highest_failed = 0;
    double lowest_safe = std::numeric_limits<double>::infinity(), highest_safe = 0;

    explicit Ranges(std::span<const Outcome> outcomes) {
        for (const Outcome& outcome : outcomes) {
            if (!(outcome.intensity > 0) || !std::isfinite(outcome.intensity))
                throw std::invalid_argument("an intensity is not positive");
            if (outcome.failed > 0) {
                lowest_failed = std::min(lowest_failed, outcome.intensity);
                highest_failed = std::max(highest_failed, outcome.intensity);
            }
            if (outcome.safe > 0) {
                lowest_safe = std::min(lowest_safe, outcome.intensity);
                highest_safe = std::max(highest_safe, outcome.intensity);
            }
        }
    }
    FitKind kind() const {
        if (highest_failed == 0) return FitKind::all_safe;
        if (highest_safe == 0) return FitKind::all_failed;
        if (highest_failed <= lowest_safe) return FitKind::not_increasing;
        if (highest_safe <= lowest_failed) return FitKind::separable;
        return FitKind::curve;
    }
};

}  // namespace

OutcomeFit fit_outcomes(std::span<const Outcome> outcomes) {
    double rows = 0, sum = 0;
    for (const Outcome& outcome : outcomes) {
        rows += outcome.failed + outcome.safe;
        sum += (outcome.failed + outcome.safe) * std::log(outcome.intensity);
    }
    if (!(rows > 0)) throw std::invalid_argument("there is no outcome");
    const Ranges ranges(outcomes);
    OutcomeFit fit;
    fit.kind = ranges.kind();
    fit.highest_safe = ranges.highest_safe;
    fit.lowest_failed = std::isinf(ranges.lowest_failed) ? 0 : ranges.lowest_failed;
    if (fit.kind != FitKind::curve) return fit;
    const double centre = sum / rows;
    double squares = 0;
    for (const Outcome& outcome : outcomes)
        squares += (outcome.failed + outcome.safe) * std::pow(std::log(outcome.intensity) - centre, 2);
    const double scale = std::sqrt(squares / rows);
    const auto likelihood = [&](const Eigen::Vector2d& point) {
        return likelihood_at(outcomes, point, scale, centre);
    };
    const Eigen::Vector2d at =
        maximise<2>(Eigen::Vector2d(0, 1), likelihood, [](const Eigen::Vector2d&) { return true; });
    if (!(at[1] > 0)) {
        fit.kind = FitKind::not_increasing;
        return fit;
    }
    fit.curve.median = std::exp(centre - scale * at[0] / at[1]);
    fit.curve.dispersion = scale / at[1];
    fit.log_likelihood = likelihood(at).value;
    return fit;
}

double bound_without_failure(double rows, double confidence) {
    return -std::expm1(std::log1p(-confidence) / rows);
}

}  // namespace rockslope::study
