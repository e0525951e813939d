#include "record/spectral_wavelets.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "record/resample.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope::record {

namespace {

constexpr double wavelet_regularisation = 1e-4;  // of the mean diagonal; 1e-2 corrects only half of a misfit
constexpr double samples_per_period = 20;
constexpr double candidate_fraction = 0.85;  // of the target; a smaller extreme cannot become the largest
constexpr double width_factor = 3;
constexpr double half_length =
    4.5;  // half length of a wavelet in widths; beyond it is below 2e-9 of its peak
constexpr int max_active_set_rounds = 4;

/// An oscillator and its response at substeps between the samples.
struct Oscillator {
    TargetOrdinate target;
    int substeps = 1;              ///< per sample
    std::vector<double> response;  ///< absolute acceleration at each substep, m/s2
    std::vector<double> hat;       ///< response to a record that is 1 at its second sample and 0 elsewhere
};

/// A local extreme of the response of an oscillator.
struct Extreme {
    std::size_t oscillator = 0, instant = 0;
    double value = 0;  ///< over the target, signed
};

/// The candidate extremes, and which of them are required to become the target.
struct Extremes {
    std::vector<Extreme> list;
    std::vector<bool> is_active;
};

/// A wavelet: its samples from `first` on, zero elsewhere.
struct Wavelet {
    std::size_t first = 0;
    std::vector<double> values;
};

std::vector<double> fine_response(const Accelerogram& record, int substeps, double period, double damping) {
    const Accelerogram fine = substeps == 1 ? record : resampled(record, record.step / substeps);
    return oscillate(fine, period, damping).absolute_acceleration;
}

Oscillator oscillator_on(const Accelerogram& record, const TargetOrdinate& target, double damping) {
    Oscillator oscillator;
    oscillator.target = target;
    oscillator.substeps =
        std::max(1, static_cast<int>(std::ceil(samples_per_period * record.step / target.period)));
    oscillator.response = fine_response(record, oscillator.substeps, target.period, damping);
    Accelerogram hat{record.step, std::vector<double>(record.values.size() + 2, 0.0)};
    hat.values[1] = 1;
    oscillator.hat = fine_response(hat, oscillator.substeps, target.period, damping);
    return oscillator;
}

std::vector<Extreme> local_extremes(const Oscillator& oscillator, std::size_t index) {
    std::vector<Extreme> extremes;
    const std::vector<double>& x = oscillator.response;
    for (std::size_t k = 1; k < x.size(); ++k) {
        const double next = k + 1 < x.size() ? std::abs(x[k + 1]) : 0;
        if (std::abs(x[k]) >= std::abs(x[k - 1]) && std::abs(x[k]) > next)
            extremes.push_back({index, k, x[k] / oscillator.target.acceleration});
    }
    return extremes;
}

bool is_smaller(const Extreme& a, const Extreme& b) {
    return std::abs(a.value) < std::abs(b.value);
}

/// The extremes above candidate_fraction of their target. Those above the target and the largest one of each
/// oscillator are active.
Extremes extremes_of(const std::vector<Oscillator>& oscillators) {
    Extremes found;
    for (std::size_t i = 0; i < oscillators.size(); ++i) {
        const std::vector<Extreme> extremes = local_extremes(oscillators[i], i);
        const auto largest = std::max_element(extremes.begin(), extremes.end(), is_smaller);
        for (auto extreme = extremes.begin(); extreme != extremes.end(); ++extreme) {
            const bool is_active = extreme == largest || std::abs(extreme->value) > 1;
            if (!is_active && std::abs(extreme->value) < candidate_fraction) continue;
            found.list.push_back(*extreme);
            found.is_active.push_back(is_active);
        }
    }
    return found;
}

/// The wavelet with the amplitude of the target to which the oscillator responds most at `time`, s.
Wavelet wavelet(const Accelerogram& record, const TargetOrdinate& target, double damping, double time) {
    const double frequency_ratio = std::sqrt(1 - damping * damping);  // damped over undamped
    const double damped = 2 * std::numbers::pi / target.period * frequency_ratio;
    const double width = width_factor * 1.178 * std::pow(target.period, 0.93);
    const double centre = time - std::atan(frequency_ratio / damping) / damped;
    const double last = static_cast<double>(record.values.size()) - 2;
    const double from = std::max(1.0, std::ceil((centre - half_length * width) / record.step));
    const double to = std::min(last, std::floor((centre + half_length * width) / record.step));
    Wavelet shape{static_cast<std::size_t>(from), {}};
    for (auto k = static_cast<std::int64_t>(from); k <= static_cast<std::int64_t>(to); ++k) {
        const double t = static_cast<double>(k) * record.step - centre;
        shape.values.push_back(target.acceleration * std::cos(damped * t) *
                               std::exp(-t * t / (width * width)));
    }
    return shape;
}

/// Response of an oscillator to a wavelet at an instant, over its target: the sum of the responses to the hat
/// functions of the samples.
double wavelet_response(const Wavelet& wavelet, const Oscillator& oscillator, std::size_t instant) {
    const std::size_t substeps = oscillator.substeps;
    double sum = 0;
    for (std::size_t k = 0; k < wavelet.values.size(); ++k) {
        const std::size_t start = (wavelet.first + k - 1) * substeps;
        if (start > instant) break;
        sum += wavelet.values[k] * oscillator.hat[instant - start];
    }
    return sum / oscillator.target.acceleration;
}

Eigen::MatrixXd response_matrix(const std::vector<Wavelet>& wavelets,
                                const std::vector<Oscillator>& oscillators,
                                const std::vector<Extreme>& extremes) {
    Eigen::MatrixXd matrix(extremes.size(), wavelets.size());
    for (std::size_t i = 0; i < extremes.size(); ++i)
        for (std::size_t j = 0; j < wavelets.size(); ++j)
            matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                wavelet_response(wavelets[j], oscillators[extremes[i].oscillator], extremes[i].instant);
    return matrix;
}

/// The amplitudes of smallest norm with which the active extremes become their targets, regularised.
Eigen::VectorXd minimum_norm_amplitudes(const Eigen::MatrixXd& full_matrix, const Extremes& extremes) {
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < extremes.list.size(); ++i)
        if (extremes.is_active[i]) rows.push_back(static_cast<Eigen::Index>(i));
    const Eigen::MatrixXd matrix = full_matrix(rows, Eigen::all);
    Eigen::VectorXd missing(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double value = extremes.list[rows[i]].value;
        missing[static_cast<Eigen::Index>(i)] = std::copysign(1, value) - value;
    }
    Eigen::MatrixXd normal = matrix * matrix.transpose();
    normal.diagonal().array() += wavelet_regularisation * normal.diagonal().mean();
    return matrix.transpose() * normal.ldlt().solve(missing);
}

/// Activates the extremes that these amplitudes lift above their target. @return whether there are any.
bool extend_active_set(Extremes& extremes, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& amplitudes) {
    const Eigen::VectorXd change = matrix * amplitudes;
    bool has_grown = false;
    for (std::size_t i = 0; i < extremes.list.size(); ++i) {
        if (extremes.is_active[i]) continue;
        if (std::abs(extremes.list[i].value + change[static_cast<Eigen::Index>(i)]) > 1)
            extremes.is_active[i] = has_grown = true;
    }
    return has_grown;
}

}  // namespace

std::vector<double> matching_wavelets(const Accelerogram& record, std::span<const TargetOrdinate> targets,
                                      double damping) {
    std::vector<Oscillator> oscillators;
    for (const TargetOrdinate& target : targets)
        oscillators.push_back(oscillator_on(record, target, damping));
    Extremes extremes = extremes_of(oscillators);
    std::vector<Wavelet> wavelets;
    for (const Extreme& extreme : extremes.list) {
        const Oscillator& oscillator = oscillators[extreme.oscillator];
        const double time = static_cast<double>(extreme.instant) * record.step / oscillator.substeps;
        wavelets.push_back(wavelet(record, oscillator.target, damping, time));
    }
    const Eigen::MatrixXd matrix = response_matrix(wavelets, oscillators, extremes.list);
    Eigen::VectorXd amplitudes = minimum_norm_amplitudes(matrix, extremes);
    for (int round = 1; round < max_active_set_rounds && extend_active_set(extremes, matrix, amplitudes);
         ++round)
        amplitudes = minimum_norm_amplitudes(matrix, extremes);

    std::vector<double> sum(record.values.size(), 0.0);
    for (std::size_t j = 0; j < wavelets.size(); ++j)
        for (std::size_t k = 0; k < wavelets[j].values.size(); ++k)
            sum[wavelets[j].first + k] += amplitudes[static_cast<Eigen::Index>(j)] * wavelets[j].values[k];
    return sum;
}

}  // namespace rockslope::record
