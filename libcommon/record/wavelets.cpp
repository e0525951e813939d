#include "record/wavelets.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "record/baseline.hpp"
#include "record/scale.hpp"

namespace rockslope::record {

namespace {

constexpr double pi = std::numbers::pi;

void check(double peak, double frequency, double step) {
    if (!(peak > 0) || !std::isfinite(peak) || !(frequency > 0) || !std::isfinite(frequency))
        throw std::invalid_argument("peak and frequency must be positive");
    if (!(step > 0) || !(step * frequency <= 0.1))
        throw std::invalid_argument("step must be positive and at most a tenth of a period");
    if (!(step * frequency >= 1e-6))
        throw std::invalid_argument("step must be a millionth of a period or more");
}

}  // namespace

Accelerogram sine_burst(double peak, double frequency, int cycles, double step) {
    check(peak, frequency, step);
    if (cycles < 2 || cycles > 10000) throw std::invalid_argument("cycles must be between 2 and 10000");
    const double length = cycles / frequency;
    const auto last = static_cast<std::size_t>(std::ceil(length / step * (1 - 1e-12)));
    Accelerogram record{step, std::vector<double>(last + 1, 0.0)};
    for (std::size_t k = 1; k < last; ++k) {
        const double t = static_cast<double>(k) * step;
        record.values[k] = std::pow(std::sin(pi * t / length), 2) * std::sin(2 * pi * frequency * t);
    }
    return scaled_to_peak(correct_baseline(record), peak);
}

Accelerogram ricker(double peak, double frequency, double step) {
    check(peak, frequency, step);
    // The middle is a sample, so the peak is exact and the wavelet is symmetric.
    const auto half = static_cast<std::size_t>(std::ceil(2 / (frequency * step)));
    Accelerogram record{step, {}};
    for (std::size_t k = 0; k <= 2 * half; ++k) {
        const double t = (static_cast<double>(k) - static_cast<double>(half)) * step;
        const double q = std::pow(pi * frequency * t, 2);
        record.values.push_back(peak * (1 - 2 * q) * std::exp(-q));
    }
    return record;
}

}  // namespace rockslope::record
