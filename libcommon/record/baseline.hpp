#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// Makes the ground stop where it started: subtracts w(t) (p + q t) from the acceleration, w(t) = sin^2(pi t
/// / T), with p and q such that velocity and displacement are zero at the end. The correction vanishes with
/// its slope at both ends, so it adds no jump; its period is the record's length, so it leaves the strong
/// motion as it was.
///
/// When the first and last samples are zero, the end is also at rest under v += dt a, u += dt v_old + dt^2 a
/// / 2, the update of the simulator: the two rules then differ by sums that telescope to zero.
/// @param record at least 4 samples, otherwise std::invalid_argument.
Accelerogram correct_baseline(const Accelerogram& record);

}  // namespace rockslope::record
