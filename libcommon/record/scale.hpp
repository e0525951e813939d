#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

// Scaling. The functions with a target throw std::invalid_argument if it is not positive or the record has no
// motion.

/// The record times a factor of either sign. @throws std::invalid_argument if the factor is not finite.
Accelerogram scaled(const Accelerogram& record, double factor);

/// The record scaled to a largest absolute acceleration of `peak`, m/s2.
Accelerogram scaled_to_peak(const Accelerogram& record, double peak);

/// The record scaled to an Arias intensity, m/s, which is proportional to the square of the factor.
Accelerogram scaled_to_arias(const Accelerogram& record, double intensity);

/// The record scaled so that the response spectrum at `period` is `acceleration`, m/s2, absolute.
/// @param period s, positive; @param damping ratio, in [0, 1).
Accelerogram scaled_to_ordinate(const Accelerogram& record, double period, double damping,
                                double acceleration);

}  // namespace rockslope::record
