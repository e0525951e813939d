#pragma once

#include <span>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// Amplification of the motion of a point relative to a base, at one period.
struct Amplification {
    double period = 0;         ///< s
    double response = 0;       ///< m/s2, absolute acceleration of an oscillator on the point
    double base_response = 0;  ///< m/s2, absolute acceleration of an oscillator on the base
    double fourier_ratio = 0;  ///< smoothed Fourier amplitude of the point over that of the base
    double base_fourier = 0;   ///< smoothed Fourier amplitude of the base over its largest value at these
                               ///< periods; where it is small, the ratio has no meaning

    double response_ratio() const { return response / base_response; }
};

/// Ratios of the response spectra and of the Fourier spectra of two accelerograms of the same event. Fourier
/// amplitudes are smoothed by the window of Konno & Ohmachi (1998), b = 40. Both records are resampled to the
/// finer step, and the shorter is padded with zeros.
/// @param periods s, positive; @param damping ratio of the oscillators. @throws std::invalid_argument for a
/// base without motion, a record of fewer than 2 samples, a damping out of range.
std::vector<Amplification> amplification(const Accelerogram& point, const Accelerogram& base,
                                         std::span<const double> periods, double damping);

}  // namespace rockslope::record
