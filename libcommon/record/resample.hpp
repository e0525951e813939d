#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The record at another step, interpolated linearly between the samples. For a coarser step a zero-phase
/// Butterworth low pass of order 8 with the corner frequency 0.4 / step comes first, against aliasing. The
/// last sample is the last that fits into the record.
/// @param step s, positive, with 2 to 10^7 samples in the record; otherwise std::invalid_argument.
Accelerogram resampled(const Accelerogram& record, double step);

}  // namespace rockslope::record
