#pragma once

#include <span>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The motion of a damped oscillator on the shaken ground, relative to it, at the accelerogram's instants.
struct OscillatorMotion {
    std::vector<double> displacement;           ///< m, relative
    std::vector<double> velocity;               ///< m/s, relative
    std::vector<double> absolute_acceleration;  ///< m/s2
};

/// Solves u'' + 2 z w u' + w^2 u = -a(t) from rest, exactly for an acceleration that is linear between
/// samples (Nigam & Jennings 1969).
/// @param period s, positive; @param damping of critical, in [0, 1); otherwise std::invalid_argument.
OscillatorMotion oscillate(const Accelerogram& record, double period, double damping);

/// One ordinate of a response spectrum: the oscillator's largest absolute values.
struct SpectralOrdinate {
    double period = 0;                 ///< s
    double displacement = 0;           ///< m, relative
    double velocity = 0;               ///< m/s, relative
    double absolute_acceleration = 0;  ///< m/s2
};

/// The response spectrum. The maxima are those at the samples, and between them at even parts, so that an
/// oscillator's period holds at least 20 instants: what is missed between them is below (pi / 20)^2 / 2 = 1.3
/// %.
std::vector<SpectralOrdinate> response_spectrum(const Accelerogram& record, std::span<const double> periods,
                                                double damping);

}  // namespace rockslope::record
