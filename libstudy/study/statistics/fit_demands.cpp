#include "study/statistics/fit_demands.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "study/statistics/maximise.hpp"

namespace rockslope::study {

namespace {

constexpr double smallest_known_weight = 2.5;  ///< of demands known, for two coefficients and the scatter
constexpr double smallest_scatter = 1e-12;     ///< of ln D; below it there is none

/// Weighted least squares of the demands that are known.
struct Sums {
    double weight = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    bool has_bounds = false;

    explicit Sums(std::span<const Demand> demands) {
        for (const Demand& d : demands) {
            if (!(d.intensity > 0) || !(d.demand > 0) || !std::isfinite(d.intensity) ||
                !std::isfinite(d.demand))
                throw std::invalid_argument("an intensity or a demand is not positive");
            if (d.weight == 0) continue;
            if (d.known != Known::value) {
                has_bounds = true;
                continue;
            }
            weight += d.weight;
            x += d.weight * std::log(d.intensity);
            y += d.weight * std::log(d.demand);
        }
        for (const Demand& d : demands) {
            if (d.known != Known::value) continue;
            const double dx = std::log(d.intensity) - x / weight, dy = std::log(d.demand) - y / weight;
            xx += d.weight * dx * dx;
            xy += d.weight * dx * dy;
            yy += d.weight * dy * dy;
        }
    }
    std::optional<DemandFit> fit() const {
        if (!(weight > smallest_known_weight) || !(xx > smallest_scatter * weight)) return std::nullopt;
        DemandFit fit;
        fit.slope = xy / xx;
        fit.intercept = (y - fit.slope * x) / weight;
        const double residual = yy - fit.slope * xy;
        if (!(residual > smallest_scatter * smallest_scatter * weight)) return std::nullopt;
        fit.sigma = std::sqrt(residual / (weight - 2));
        fit.sigma_likeliest = std::sqrt(residual / weight);
        fit.log_likelihood =
            -weight * (std::log(fit.sigma_likeliest) + (1 + std::log(2 * std::numbers::pi)) / 2);
        return fit;
    }
};

/// The log-likelihood in p = (a, b, 1) / sigma, which is concave. The standardised residual of a row is
/// direction . p.
LogLikelihood<3> likelihood_at(std::span<const Demand> demands, const Eigen::Vector3d& p) {
    LogLikelihood<3> sum;
    for (const Demand& d : demands) {
        const Eigen::Vector3d direction(-1, -std::log(d.intensity), std::log(d.demand));
        if (d.known != Known::value) {
            sum.add_normal(d.weight, d.known == Known::at_least ? -direction : direction, p);
            continue;
        }
        const double z = direction.dot(p);
        sum.value += d.weight * (std::log(p[2]) - z * z / 2 - std::log(2 * std::numbers::pi) / 2);
        sum.gradient -= d.weight * z * direction;
        sum.gradient[2] += d.weight / p[2];
        sum.curvature += d.weight * direction * direction.transpose();
        sum.curvature(2, 2) += d.weight / (p[2] * p[2]);
    }
    return sum;
}

std::optional<DemandFit> fit_censored(std::span<const Demand> demands, const DemandFit& start) {
    const auto likelihood = [&](const Eigen::Vector3d& point) { return likelihood_at(demands, point); };
    const Eigen::Vector3d first = Eigen::Vector3d(start.intercept, start.slope, 1) / start.sigma_likeliest;
    const Eigen::Vector3d p =
        maximise<3>(first, likelihood, [](const Eigen::Vector3d& point) { return point[2] > 0; });
    if (!p.allFinite()) return std::nullopt;
    return DemandFit{p[0] / p[2], p[1] / p[2], 1 / p[2], 1 / p[2], likelihood(p).value};
}

}  // namespace

std::optional<LognormalCurve> DemandFit::curve(double limit) const {
    if (!(slope > 0)) return std::nullopt;
    return LognormalCurve{std::exp((std::log(limit) - intercept) / slope), sigma / slope};
}

std::optional<DemandFit> fit_demands(std::span<const Demand> demands) {
    const Sums sums(demands);
    const std::optional<DemandFit> fit = sums.fit();
    return fit && sums.has_bounds ? fit_censored(demands, *fit) : fit;
}

}  // namespace rockslope::study
