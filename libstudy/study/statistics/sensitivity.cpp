#include "study/statistics/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace rockslope::study {

namespace {

constexpr int bootstrap_samples = 500;

double mean_of(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double variance_of(std::span<const double> values) {
    const double mean = mean_of(values);
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// The two indices from the base rows that `rows` lists.
SensitivityIndex index_of(std::span<const double> a, std::span<const double> b, std::span<const double> mixed,
                          std::span<const std::size_t> rows) {
    std::vector<double> all;
    double first = 0, total = 0;
    for (const std::size_t k : rows) {
        all.push_back(a[k]);
        all.push_back(b[k]);
        first += b[k] * (mixed[k] - a[k]);
        total += (a[k] - mixed[k]) * (a[k] - mixed[k]);
    }
    const double variance = variance_of(all);
    const auto count = static_cast<double>(rows.size());
    if (!(variance > 0)) return {};
    return {first / count / variance, total / (2 * count) / variance, 0, 0};
}

/// The variance of the means over rows with equal keys, each mean weighted by its rows.
double variance_of_means(const std::vector<std::vector<int>>& keys, std::span<const double> values) {
    std::map<std::vector<int>, std::pair<double, double>> sums;
    for (std::size_t row = 0; row < values.size(); ++row) {
        auto& [sum, count] = sums[keys[row]];
        sum += values[row];
        count += 1;
    }
    const double mean = mean_of(values);
    double variance = 0;
    for (const auto& [key, entry] : sums) {
        const double difference = entry.first / entry.second - mean;
        variance += entry.second * difference * difference;
    }
    return variance / static_cast<double>(values.size());
}

}  // namespace

std::vector<SensitivityIndex> sobol_indices(std::span<const double> a, std::span<const double> b,
                                            const std::vector<std::vector<double>>& mixed) {
    // Less their mean: the estimator of the first order loses digits where the mean is large.
    std::vector<double> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    const double mean = mean_of(all);
    const auto centred = [&](std::span<const double> values) {
        std::vector<double> result(values.begin(), values.end());
        for (double& value : result) value -= mean;
        return result;
    };
    const std::vector<double> of_a = centred(a), of_b = centred(b);
    std::vector<SensitivityIndex> indices;
    std::vector<std::size_t> rows(a.size());
    for (const std::vector<double>& column : mixed) {
        const std::vector<double> of_mixed = centred(column);
        for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = k;
        SensitivityIndex index = index_of(of_a, of_b, of_mixed, rows);
        std::mt19937_64 generator(1);
        std::vector<double> firsts, totals;
        for (int sample = 0; sample < bootstrap_samples; ++sample) {
            for (std::size_t& row : rows) row = generator() % rows.size();
            const SensitivityIndex drawn = index_of(of_a, of_b, of_mixed, rows);
            firsts.push_back(drawn.first);
            totals.push_back(drawn.total);
        }
        index.first_error = std::sqrt(variance_of(firsts));
        index.total_error = std::sqrt(variance_of(totals));
        indices.push_back(index);
    }
    return indices;
}

std::vector<SensitivityIndex> factorial_indices(const std::vector<std::vector<int>>& levels,
                                                std::span<const double> values) {
    const double variance = variance_of(values);
    std::vector<SensitivityIndex> indices;
    for (std::size_t factor = 0; factor < levels.size(); ++factor) {
        std::vector<std::vector<int>> alone(values.size()), without(values.size());
        for (std::size_t row = 0; row < values.size(); ++row)
            for (std::size_t k = 0; k < levels.size(); ++k)
                (k == factor ? alone : without)[row].push_back(levels[k][row]);
        SensitivityIndex index;
        if (variance > 0) {
            index.first = variance_of_means(alone, values) / variance;
            index.total = 1 - variance_of_means(without, values) / variance;
        }
        indices.push_back(index);
    }
    return indices;
}

std::vector<ElementaryEffects> summarise_effects(const std::vector<std::vector<double>>& effects) {
    std::vector<ElementaryEffects> result;
    for (const std::vector<double>& of_factor : effects) {
        ElementaryEffects summary;
        summary.count = static_cast<int>(of_factor.size());
        summary.mean = mean_of(of_factor);
        std::vector<double> sizes;
        for (const double effect : of_factor) sizes.push_back(std::abs(effect));
        summary.mean_absolute = mean_of(sizes);
        if (of_factor.size() > 1)
            summary.deviation = std::sqrt(variance_of(of_factor) * static_cast<double>(of_factor.size()) /
                                          static_cast<double>(of_factor.size() - 1));
        result.push_back(summary);
    }
    return result;
}

}  // namespace rockslope::study
