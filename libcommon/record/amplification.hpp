#pragma once

#include <span>
#include <vector>

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// How much more a point moves than another, at one period.
struct Amplification {
    double period = 0;         ///< s
    double response = 0;       ///< m/s2, absolute acceleration of an oscillator on the point
    double base_response = 0;  ///< m/s2, on the other
    double fourier_ratio = 0;  ///< of smoothed Fourier amplitudes
    double base_fourier = 0;   ///< of the other, smoothed, over its largest at these periods: where it is
                               ///< small, the ratio says nothing

    double response_ratio() const { return response / base_response; }
};

/// Ratios of the response spectra and of the Fourier spectra of two accelerograms of one shaking. Fourier
/// amplitudes are smoothed by the window of Konno & Ohmachi (1998), b = 40; both records are brought to the
/// finer of their steps, and zeros stand behind the shorter.
/// @param periods s, positive; @param damping of the oscillators. @throws std::invalid_argument for a base
/// without motion, a record of fewer than 2 samples, a damping out of range.
std::vector<Amplification> amplification(const Accelerogram& point, const Accelerogram& base,
                                         std::span<const double> periods, double damping);

}  // namespace rockslope::record
