#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// Subtracts w(t) (p + q t) from the acceleration, w(t) = sin^2(pi t / T), with p and q such that velocity
/// and displacement are zero at the end. The correction and its slope vanish at both ends, so it adds no
/// jump. Its period is the length of the record, so it does not change the strong motion.
///
/// If the first and last samples are zero, the end is also at rest under the simulator's update v += dt a,
/// u += dt v_old + dt^2 a / 2, because the two rules then differ by sums that telescope to zero.
/// @param record at least 4 samples, otherwise std::invalid_argument.
Accelerogram correct_baseline(const Accelerogram& record);

}  // namespace rockslope::record
