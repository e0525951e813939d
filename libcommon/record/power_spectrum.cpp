#include "record/power_spectrum.hpp"

#include <cmath>
#include <numbers>

namespace rockslope::record {

double ground_density(const PowerSpectrum& spectrum, double frequency) {
    const double r2 = std::pow(frequency / spectrum.ground_frequency, 2);
    const double damping_term = 4 * std::pow(spectrum.ground_damping, 2) * r2;
    return (1 + damping_term) / (std::pow(1 - r2, 2) + damping_term) *
           std::exp(-2 * std::numbers::pi * spectrum.kappa * frequency);
}

double low_cut_gain(const PowerSpectrum& spectrum, double frequency) {
    const double s2 = std::pow(frequency / spectrum.low_cut_frequency, 2);
    return s2 * s2 / (std::pow(1 - s2, 2) + 4 * std::pow(spectrum.low_cut_damping, 2) * s2);
}

double density(const PowerSpectrum& spectrum, double frequency) {
    return ground_density(spectrum, frequency) * low_cut_gain(spectrum, frequency);
}

}  // namespace rockslope::record
