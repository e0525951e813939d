#include "blockgen/fit/direction_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace rockslope::blockgen {

namespace {

using std::numbers::pi;

constexpr std::size_t max_sets = 6;
constexpr std::size_t min_members = 5;        ///< fewer directions are no set
constexpr double least_sd = 0.01 * pi / 180;  ///< of directions that do not scatter, which digits round

/// A mixture, and what it says of the directions.
struct Mixture {
    std::vector<DirectionSet> sets;
    double log_likelihood = -std::numeric_limits<double>::infinity();
};

double density(const DirectionSet& set, double direction) {
    const double z = axial_difference(direction, set.mean) / set.sd;
    return set.share * std::exp(-z * z / 2) / (set.sd * std::sqrt(2 * pi));
}

/// One round of expectation-maximisation. @return false when a set has lost its members.
bool improve(const std::vector<double>& directions, Mixture& mixture) {
    const std::size_t n = mixture.sets.size();
    std::vector<double> weight(n, 0), shift(n, 0), square(n, 0), p(n);
    mixture.log_likelihood = 0;
    for (const double direction : directions) {
        double sum = 1e-300;
        for (std::size_t k = 0; k < n; ++k) sum += p[k] = density(mixture.sets[k], direction);
        mixture.log_likelihood += std::log(sum);
        for (std::size_t k = 0; k < n; ++k) {
            const double d = axial_difference(direction, mixture.sets[k].mean), r = p[k] / sum;
            weight[k] += r;
            shift[k] += r * d;
            square[k] += r * d * d;
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        if (weight[k] < static_cast<double>(std::min(min_members, directions.size()))) return false;
        DirectionSet& set = mixture.sets[k];
        const double mean = shift[k] / weight[k];
        set.share = weight[k] / static_cast<double>(directions.size());
        set.mean += mean;
        set.sd = std::max(std::sqrt(std::max(square[k] / weight[k] - mean * mean, 0.0)), least_sd);
    }
    return true;
}

/// The peaks of the density of directions, the highest first: a kernel estimate on a grid of degrees.
std::vector<double> peaks_of(const std::vector<double>& directions) {
    constexpr int degree_bins = 180;
    constexpr double kernel = 4 * pi / 180;
    std::vector<double> height(degree_bins, 0);
    std::vector<int> count(degree_bins, 0);
    for (const double direction : directions) {
        const auto bin = static_cast<int>(std::floor((direction / pi + 1) * degree_bins));
        ++count[((bin % degree_bins) + degree_bins) % degree_bins];
    }
    for (int i = 0; i < degree_bins; ++i)
        for (int j = 0; j < degree_bins; ++j) {
            const double z = axial_difference((i - j) * pi / degree_bins, 0) / kernel;
            height[i] += count[j] * std::exp(-z * z / 2);
        }
    std::vector<int> peaks;
    for (int i = 0; i < degree_bins; ++i)
        if (height[i] > height[(i + degree_bins - 1) % degree_bins] &&
            height[i] >= height[(i + 1) % degree_bins])
            peaks.push_back(i);
    std::stable_sort(peaks.begin(), peaks.end(), [&](int i, int j) { return height[i] > height[j]; });
    std::vector<double> angles;
    for (const int i : peaks) angles.push_back((i + 0.5) * pi / degree_bins);
    return angles;
}

/// The mixture of a number of sets, begun at the highest peaks and, beyond them, between these.
std::optional<Mixture> fit_mixture(const std::vector<double>& directions, const std::vector<double>& peaks,
                                   std::size_t count) {
    constexpr int most_steps = 500;
    constexpr double start_sd = 8 * pi / 180;
    Mixture mixture;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t round_of_peaks = k / std::max<std::size_t>(peaks.size(), 1);
        const double offset = 0.3 * static_cast<double>(round_of_peaks);
        const double start = peaks.empty() ? 0 : peaks[k % peaks.size()];
        mixture.sets.push_back({1 / static_cast<double>(count), start + offset, start_sd});
    }
    double last = -std::numeric_limits<double>::infinity();
    for (int round = 0; round < most_steps; ++round) {
        if (!improve(directions, mixture)) return std::nullopt;
        if (mixture.log_likelihood - last < 1e-7 * std::abs(mixture.log_likelihood) && round > 5) break;
        last = mixture.log_likelihood;
    }
    return mixture;
}

Mixture best_mixture(const std::vector<double>& directions, std::size_t count) {
    const std::vector<double> peaks = peaks_of(directions);
    Mixture best;
    double least = std::numeric_limits<double>::infinity();
    const auto n = static_cast<double>(directions.size());
    for (std::size_t k = count > 0 ? count : 1; k <= (count > 0 ? count : max_sets); ++k) {
        const std::optional<Mixture> mixture = fit_mixture(directions, peaks, k);
        if (!mixture) continue;
        const double criterion =
            -2 * mixture->log_likelihood + (3 * static_cast<double>(k) - 1) * std::log(n);
        if (criterion < least) least = criterion, best = *mixture;
    }
    if (best.sets.empty()) best.sets = {DirectionSet{}};
    for (DirectionSet& set : best.sets) set.mean = axial_difference(set.mean, 0);
    std::stable_sort(best.sets.begin(), best.sets.end(),
                     [](const DirectionSet& a, const DirectionSet& b) { return a.share > b.share; });
    return best;
}

}  // namespace

double axial_difference(double a, double b) {
    return std::remainder(a - b, pi);
}

DirectionSets divide_directions(const std::vector<double>& directions, std::size_t count) {
    DirectionSets result;
    result.sets = best_mixture(directions, count).sets;
    const std::size_t sets = result.sets.size();
    result.probability.resize(sets);
    for (const double direction : directions) {
        double sum = 1e-300;
        std::size_t best = 0;
        for (std::size_t k = 0; k < sets; ++k) {
            const double p = density(result.sets[k], direction);
            sum += p;
            result.probability[k].push_back(p);
            if (p > result.probability[best].back()) best = k;
        }
        for (std::vector<double>& probability : result.probability) probability.back() /= sum;
        result.set_of.push_back(best);
    }
    return result;
}

}  // namespace rockslope::blockgen
