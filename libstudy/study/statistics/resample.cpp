#include "study/statistics/resample.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <random>

namespace rockslope::study {

namespace {

/// Covariance of (ln median, ln dispersion) over the samples of one grouping.
struct Spread {
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    int fitted = 0;
};

/// A number below `count`, the same on every platform.
std::size_t draw_below(std::mt19937_64& generator, std::size_t count) {
    const double unit = static_cast<double>(generator() >> 11u) * 0x1p-53;
    return std::min(static_cast<std::size_t>(unit * static_cast<double>(count)), count - 1);
}

Spread spread_of(const WeightedFit& fit, const Grouping& grouping, const BootstrapOptions& options) {
    std::mt19937_64 generator(options.seed);
    const std::size_t count = static_cast<std::size_t>(grouping.count);
    std::vector<double> weight_of_group(count), weights(grouping.group_of.size());
    std::vector<Eigen::Vector2d> points;
    for (int sample = 0; sample < options.samples; ++sample) {
        std::fill(weight_of_group.begin(), weight_of_group.end(), 0.0);
        for (std::size_t k = 0; k < count; ++k) ++weight_of_group[draw_below(generator, count)];
        for (std::size_t row = 0; row < weights.size(); ++row)
            weights[row] = weight_of_group[static_cast<std::size_t>(grouping.group_of[row])];
        if (const auto curve = fit(weights))
            points.emplace_back(std::log(curve->median), std::log(curve->dispersion));
    }
    Spread spread;
    spread.fitted = static_cast<int>(points.size());
    if (points.size() < 2) return spread;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points) mean += point / static_cast<double>(points.size());
    for (const Eigen::Vector2d& point : points)
        spread.covariance +=
            (point - mean) * (point - mean).transpose() / static_cast<double>(points.size() - 1);
    spread.covariance *= static_cast<double>(count) / std::max(1.0, static_cast<double>(count) - 1);
    return spread;
}

Grouping each_row(std::size_t rows) {
    Grouping grouping{"row", std::vector<int>(rows), static_cast<int>(rows)};
    for (std::size_t k = 0; k < rows; ++k) grouping.group_of[k] = static_cast<int>(k);
    return grouping;
}

/// Groups of rows that are in the same group of both.
Grouping both(const Grouping& a, const Grouping& b) {
    std::vector<std::string> labels;
    for (std::size_t k = 0; k < a.group_of.size(); ++k)
        labels.push_back(std::to_string(a.group_of[k]) + " " + std::to_string(b.group_of[k]));
    return group_by(a.name + " and " + b.name, labels);
}

Eigen::Matrix2d combined(const Eigen::Matrix2d& first, const Eigen::Matrix2d& second,
                         const Eigen::Matrix2d& of_both) {
    const Eigen::Matrix2d larger = first.trace() > second.trace() ? first : second;
    const Eigen::Matrix2d sum = first + second - of_both;
    const bool is_larger = sum(0, 0) >= larger(0, 0) && sum(1, 1) >= larger(1, 1) && sum.determinant() >= 0;
    return is_larger ? sum : larger;
}

}  // namespace

double CurveBand::median_factor() const {
    return std::exp(quantile * std::sqrt(median_variance));
}

double CurveBand::dispersion_factor() const {
    return std::exp(quantile * std::sqrt(dispersion_variance));
}

std::pair<double, double> CurveBand::probability(double intensity) const {
    const double z = std::log(intensity / curve.median) / curve.dispersion;
    const double by_median = -1 / curve.dispersion, by_dispersion = -z;
    const double variance = by_median * by_median * median_variance +
                            2 * by_median * by_dispersion * covariance +
                            by_dispersion * by_dispersion * dispersion_variance;
    const double reach = quantile * std::sqrt(std::max(0.0, variance));
    return {normal_cdf(z - reach), normal_cdf(z + reach)};
}

std::optional<CurveBand> bootstrap(const WeightedFit& fit, std::size_t rows,
                                   const std::vector<Grouping>& groupings, const BootstrapOptions& options) {
    const std::vector<double> once(rows, 1.0);
    const auto curve = fit(once);
    if (!curve) return std::nullopt;
    const Grouping first = groupings.empty() ? each_row(rows) : groupings.front();
    int fewest = first.count;
    const Spread of_first = spread_of(fit, first, options);
    int fitted = of_first.fitted;
    Eigen::Matrix2d covariance = of_first.covariance;
    if (groupings.size() > 1) {
        const Grouping& second = groupings[1];
        const Spread of_second = spread_of(fit, second, options);
        const Spread of_both = spread_of(fit, both(first, second), options);
        covariance = combined(covariance, of_second.covariance, of_both.covariance);
        fitted = std::min(fitted, of_second.fitted);
        fewest = std::min(fewest, second.count);
    }
    const double share = static_cast<double>(fitted) / options.samples;
    if (fewest < 2 || share < least_fitted_share) return std::nullopt;
    const boost::math::students_t student(fewest - 1);
    return CurveBand{*curve,
                     covariance(0, 0),
                     covariance(1, 1),
                     covariance(0, 1),
                     boost::math::quantile(student, (1 + options.confidence) / 2),
                     share};
}

Grouping group_by(const std::string& name, std::span<const std::string> labels) {
    Grouping grouping{name, {}, 0};
    std::map<std::string, int> known;
    for (const std::string& label : labels)
        grouping.group_of.push_back(known.try_emplace(label, static_cast<int>(known.size())).first->second);
    grouping.count = static_cast<int>(known.size());
    return grouping;
}

}  // namespace rockslope::study
