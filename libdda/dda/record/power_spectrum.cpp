#include "dda/record/power_spectrum.hpp"

#include <cmath>
#include <numbers>

namespace dda {

double density(const PowerSpectrum& spectrum, double frequency) {
    const double r2 = std::pow(frequency / spectrum.ground_frequency, 2);
    const double ground = 4 * std::pow(spectrum.ground_damping, 2) * r2;
    const double s2 = std::pow(frequency / spectrum.low_cut_frequency, 2);
    const double low_cut = 4 * std::pow(spectrum.low_cut_damping, 2) * s2;
    const double kanai_tajimi = (1 + ground) / (std::pow(1 - r2, 2) + ground);
    const double clough_penzien = s2 * s2 / (std::pow(1 - s2, 2) + low_cut);
    return kanai_tajimi * clough_penzien * std::exp(-2 * std::numbers::pi * spectrum.kappa * frequency);
}

}  // namespace dda
