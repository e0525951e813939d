#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// The record minus its mean over the first `until` seconds, before the shaking; 0 means over the whole
/// record.
/// @param until s, from 0 to the length of the record; otherwise std::invalid_argument.
Accelerogram without_mean(const Accelerogram& record, double until);

/// The record minus the derivative of the polynomial fitted to the velocity by least squares.
/// @param degree of the polynomial, 1 to 3. @throws std::invalid_argument for another degree and for a
/// record of fewer than degree + 2 samples.
Accelerogram without_velocity_trend(const Accelerogram& record, int degree);

/// Removes the slow drift of a raw record by a zero-phase Butterworth high pass (Boore 2005). Zeros are added
/// first at both ends, 0.75 order / corner seconds each. They stay in the result, because velocity and
/// displacement need them to come to rest. The filter also removes permanent displacement.
/// @param corner Hz, and @param order 1 to 12, see butterworth(). @throws std::invalid_argument for padding
/// of 10^7 samples or more.
Accelerogram high_passed(const Accelerogram& record, double corner, int order);

/// Corrects the baseline shift of a raw near-source record; permanent displacement stays (Iwan, Moser & Peng
/// 1985). A line is fitted to the velocity from `shift_end` to the end of the record, and its slope is
/// subtracted from the acceleration there. The value of the line at `shift_end` is removed by a constant
/// acceleration from `shift_start` to `shift_end`. The remaining final velocity is removed by a sin^2 pulse
/// in the same interval.
/// @param shift_start, shift_end s, increasing, at least 3 samples apart and 3 samples before the end;
/// otherwise std::invalid_argument.
Accelerogram correct_baseline_shift(const Accelerogram& record, double shift_start, double shift_end);

}  // namespace rockslope::record
