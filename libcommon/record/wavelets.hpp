#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// Whole cycles of a sine under the envelope sin^2(pi t / T), T = cycles / frequency, baseline-corrected so
/// that the ground ends at rest where it started.
/// @param peak m/s2, largest absolute acceleration; @param frequency Hz; @param cycles 2 to 10000;
/// @param step s, at most a tenth of a period. All positive; otherwise std::invalid_argument.
Accelerogram sine_burst(double peak, double frequency, int cycles, double step);

/// Ricker wavelet, a = peak (1 - 2 q) exp(-q) with q = (pi f (t - 2 / f))^2, from 0 to 4 / f. Its spectrum is
/// largest at f. Velocity and displacement return to zero. Parameters as above.
Accelerogram ricker(double peak, double frequency, double step);

}  // namespace rockslope::record
