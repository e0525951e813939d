#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The record at another step. Finer: linear between the samples, as it is understood everywhere. Coarser:
/// what the new step cannot carry is taken out first, by a zero-phase Butterworth low pass of order 8 at 0.4
/// / step, so that it does not come back as motion of a lower frequency. The last sample is the last that
/// fits into the record.
/// @param step s, positive, with 2 to 10^7 samples in the record; otherwise std::invalid_argument.
Accelerogram resampled(const Accelerogram& record, double step);

}  // namespace rockslope::record
