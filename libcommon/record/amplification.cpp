#include "record/amplification.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

#include "record/resample.hpp"
#include "record/response_spectrum.hpp"

namespace rockslope::record {

namespace {

constexpr double bandwidth = 40;  // b of the window; its half height is a fifteenth of the frequency away
constexpr double reach = 3.14159265358979 / bandwidth;  // decades, to the window's first zero

/// Amplitudes at the multiples of 1 / (size * step).
std::vector<double> fourier_amplitudes(std::vector<double> values, std::size_t size) {
    values.resize(size, 0.0);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> fft;
    fft.fwd(spectrum, values);
    std::vector<double> amplitudes;
    for (std::size_t k = 0; k <= size / 2; ++k) amplitudes.push_back(std::abs(spectrum[k]));
    return amplitudes;
}

/// Konno and Ohmachi's window, (sin(b log10 f/f0) / (b log10 f/f0))^4.
double window(double decades) {
    const double x = bandwidth * decades;
    return std::abs(x) < 1e-6 ? 1 : std::pow(std::sin(x) / x, 4);
}

/// The smoothed amplitude at a harmonic number, which need not be an integer.
double smoothed(const std::vector<double>& amplitudes, double harmonic) {
    const double last = static_cast<double>(amplitudes.size() - 1);
    const auto from = static_cast<std::size_t>(std::clamp(harmonic * std::pow(10, -reach), 1.0, last));
    const auto to =
        static_cast<std::size_t>(std::clamp(std::ceil(harmonic * std::pow(10, reach)), 1.0, last));
    double sum = 0, weights = 0;
    for (std::size_t k = from; k <= to; ++k) {
        const double weight = window(std::log10(static_cast<double>(k) / harmonic));
        sum += weight * amplitudes[k];
        weights += weight;
    }
    return weights > 0 ? sum / weights : amplitudes[from];
}

Accelerogram at_step(const Accelerogram& record, double step) {
    return std::abs(record.step - step) < 1e-9 * step ? record : resampled(record, step);
}

}  // namespace

std::vector<Amplification> amplification(const Accelerogram& point, const Accelerogram& base,
                                         std::span<const double> periods, double damping) {
    if (point.values.size() < 2 || base.values.size() < 2)
        throw std::invalid_argument("a record of fewer than two samples has no spectrum");
    if (!(largest_magnitude(base.values) > 0))
        throw std::invalid_argument("the base does not move, so there is no amplification");
    const double step = std::min(point.step, base.step);
    const std::vector<double> point_values = at_step(point, step).values;
    const std::vector<double> base_values = at_step(base, step).values;
    const std::size_t size = 2 * std::bit_ceil(std::max(point_values.size(), base_values.size()));
    const auto point_amplitudes = fourier_amplitudes(point_values, size);
    const auto base_amplitudes = fourier_amplitudes(base_values, size);
    const auto point_response = response_spectrum(point, periods, damping);
    const auto base_response = response_spectrum(base, periods, damping);
    const double length = static_cast<double>(size) * step;
    std::vector<Amplification> table;
    double largest = 0;
    for (std::size_t k = 0; k < periods.size(); ++k) {
        const double base_amplitude = smoothed(base_amplitudes, length / periods[k]);
        table.push_back({periods[k], point_response[k].absolute_acceleration,
                         base_response[k].absolute_acceleration,
                         smoothed(point_amplitudes, length / periods[k]) / base_amplitude, base_amplitude});
        largest = std::max(largest, base_amplitude);
    }
    for (Amplification& a : table) a.base_fourier = largest > 0 ? a.base_fourier / largest : 0;
    return table;
}

}  // namespace rockslope::record
