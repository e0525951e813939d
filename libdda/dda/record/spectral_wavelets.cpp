#include "dda/record/spectral_wavelets.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dda/record/resample.hpp"
#include "dda/record/response_spectrum.hpp"

namespace dda {

namespace {

constexpr double regularisation = 0.01;  // of the mean diagonal of the normal equations
constexpr double samples_per_period = 20;

/// The largest response of an oscillator to a record, with its sign, and when it is.
struct Peak {
    std::size_t sample = 0;
    double value = 0;  ///< m/s2
};

Peak peak_of(const std::vector<double>& response) {
    const auto largest = std::max_element(response.begin(), response.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); });
    return {static_cast<std::size_t>(largest - response.begin()), *largest};
}

/// The wavelet of a period whose oscillator responds to it most at `time`, sampled as the record.
std::vector<double> wavelet(const Accelerogram& record, double period, double damping, double time) {
    const double frequency = 1 / period;
    const double damped = 2 * std::numbers::pi * frequency * std::sqrt(1 - damping * damping);
    const double width = 1.178 * std::pow(frequency, -0.93);
    const double lag = std::atan(std::sqrt(1 - damping * damping) / damping) / damped;
    std::vector<double> values(record.values.size(), 0.0);
    for (std::size_t k = 1; k + 1 < values.size(); ++k) {
        const double t = static_cast<double>(k) * record.step - time + lag;
        values[k] = std::cos(damped * t) * std::exp(-t * t / (width * width));
    }
    return values;
}

/// Linear between the samples, so many parts of a step.
Accelerogram finer(const Accelerogram& record, int parts) {
    return parts == 1 ? record : resampled(record, record.step / parts);
}

/// Responses at the samples to a motion that is 1 at the second sample, 0 at all others.
std::vector<double> response_to_hat(const Accelerogram& like, double period, double damping) {
    Accelerogram hat{like.step, std::vector<double>(like.values.size() + 1, 0.0)};
    hat.values[1] = 1;
    return oscillate(hat, period, damping).absolute_acceleration;
}

/// The response at a sample to a motion, the sum of those to its samples' hats.
double response_at(std::size_t sample, const std::vector<double>& hat, const std::vector<double>& motion) {
    double sum = 0;
    for (std::size_t k = 0; k <= sample; ++k) sum += motion[k] * hat[sample - k + 1];
    return sum;
}

}  // namespace

Accelerogram with_wavelets(const Accelerogram& record, std::span<const SpectralAim> aims, double damping,
                           double share) {
    double shortest = aims.front().period;
    for (const SpectralAim& aim : aims) shortest = std::min(shortest, aim.period);
    const int parts = std::max(1, static_cast<int>(std::ceil(samples_per_period * record.step / shortest)));
    const Accelerogram fine = finer(record, parts);
    const auto count = static_cast<Eigen::Index>(aims.size());
    std::vector<Peak> peaks;
    Eigen::VectorXd missing(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const SpectralAim& aim = aims[static_cast<std::size_t>(i)];
        peaks.push_back(peak_of(oscillate(fine, aim.period, damping).absolute_acceleration));
        const double value = peaks.back().value;
        // In shares of the aim, so that long periods count as much as short ones.
        missing[i] = (std::copysign(aim.acceleration, value) - value) / aim.acceleration;
    }

    Eigen::MatrixXd effect(count, count);
    std::vector<std::vector<double>> wavelets, shapes;
    for (Eigen::Index j = 0; j < count; ++j) {
        const double time = static_cast<double>(peaks[static_cast<std::size_t>(j)].sample) * fine.step;
        wavelets.push_back(wavelet(record, aims[static_cast<std::size_t>(j)].period, damping, time));
        shapes.push_back(finer({record.step, wavelets.back()}, parts).values);
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto& aim = aims[static_cast<std::size_t>(i)];
        const std::vector<double> hat = response_to_hat(fine, aim.period, damping);
        const std::size_t instant = peaks[static_cast<std::size_t>(i)].sample;
        for (Eigen::Index j = 0; j < count; ++j)
            effect(i, j) = response_at(instant, hat, shapes[static_cast<std::size_t>(j)]) / aim.acceleration;
    }
    Eigen::MatrixXd normal = effect.transpose() * effect;
    normal.diagonal().array() += regularisation * normal.diagonal().mean();
    const Eigen::VectorXd size = normal.ldlt().solve(effect.transpose() * missing);

    Accelerogram changed = record;
    for (Eigen::Index j = 0; j < count; ++j)
        for (std::size_t k = 0; k < changed.values.size(); ++k)
            changed.values[k] += share * size[j] * wavelets[static_cast<std::size_t>(j)][k];
    return changed;
}

}  // namespace dda
