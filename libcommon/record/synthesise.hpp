#pragma once

#include <cstdint>

#include "record/accelerogram.hpp"
#include "record/envelope.hpp"
#include "record/power_spectrum.hpp"

namespace rockslope::record {

/// Parameters of an artificial accelerogram.
struct SyntheticMotion {
    std::uint64_t seed = 1;
    double step = 0.005;   ///< s, positive
    double duration = 20;  ///< s, a whole number of steps, at least 10
    double peak = 3.43;    ///< m/s2, positive
    PowerSpectrum spectrum;
    Envelope envelope;
};

/// An artificial accelerogram, in six steps:
///   1. stationary Gaussian-like noise with the density of ground_density, by the spectral representation
///      (Shinozuka & Deodatis 1991), a(t) = sum_k sqrt(2 S_g(f_k) df) cos(2 pi f_k t + phi_k), with uniform
///      phases phi_k from a counter-based generator (Salmon et al. 2011) keyed by the seed. f_k are the
///      multiples of 1 / (2 duration) up to half the sampling rate, so the noise does not repeat within the
///      record;
///   2. multiplication by the envelope;
///   3. low-cut filter in the time domain. It comes after the envelope, which would bring the lowest
///      frequencies back (Rezaeian & Der Kiureghian 2010);
///   4. taper to zero over the last second, or over the last tenth of the record if that is less;
///   5. baseline correction;
///   6. scaling to the largest absolute value `peak`.
/// The first and last samples are zero, and the ground ends at rest where it started.
/// @throws std::invalid_argument for a parameter outside its range.
Accelerogram synthesise(const SyntheticMotion& recipe);

}  // namespace rockslope::record
