#pragma once

#include <span>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The motion of a damped oscillator on shaking ground, at the samples of the accelerogram.
struct OscillatorMotion {
    std::vector<double> displacement;           ///< m, relative to the ground
    std::vector<double> velocity;               ///< m/s, relative to the ground
    std::vector<double> absolute_acceleration;  ///< m/s2
};

/// Solves u'' + 2 z w u' + w^2 u = -a(t) from rest, exactly for an acceleration that is linear between
/// samples (Nigam & Jennings 1969).
/// @param period s, positive; @param damping ratio z, in [0, 1); otherwise std::invalid_argument.
OscillatorMotion oscillate(const Accelerogram& record, double period, double damping);

/// One ordinate of a response spectrum: the largest absolute values of the oscillator's motion.
struct SpectralOrdinate {
    double period = 0;                 ///< s
    double displacement = 0;           ///< m, relative
    double velocity = 0;               ///< m/s, relative
    double absolute_acceleration = 0;  ///< m/s2
};

/// The response spectrum. The maxima are taken at the samples and at equal substeps between them, at least
/// 20 per period of the oscillator. The error of a maximum is then below (pi / 20)^2 / 2 = 1.3 %.
std::vector<SpectralOrdinate> response_spectrum(const Accelerogram& record, std::span<const double> periods,
                                                double damping);

}  // namespace rockslope::record
