#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The record times a factor, of either sign, finite; otherwise std::invalid_argument.
Accelerogram scaled(const Accelerogram& record, double factor);

/// Scaled by a positive factor so that the largest absolute acceleration is `peak`, m/s2.
Accelerogram scaled_to_peak(const Accelerogram& record, double peak);

/// Scaled so that the Arias intensity, m/s, is the one given: it grows with the square of the factor.
Accelerogram scaled_to_arias(const Accelerogram& record, double intensity);

/// Scaled so that an oscillator's largest absolute acceleration is `acceleration`, m/s2.
/// @param period s, positive; @param damping of critical, in [0, 1).
Accelerogram scaled_to_ordinate(const Accelerogram& record, double period, double damping,
                                double acceleration);
// Each throws std::invalid_argument for a target that is not positive, and for a record that does not move.

}  // namespace rockslope::record
