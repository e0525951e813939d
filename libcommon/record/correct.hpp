#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

/// Less its mean over the first `until` seconds, when nothing shook yet; over all of it when `until` is 0.
/// @param until s, from 0 to the record's length; otherwise std::invalid_argument.
Accelerogram without_mean(const Accelerogram& record, double until);

/// Less the derivative of the polynomial that fits the velocity best, by least squares over the record.
/// @param degree of the polynomial, 1 to 3, of a record of more samples than that; otherwise
/// std::invalid_argument.
Accelerogram without_velocity_trend(const Accelerogram& record, int degree);

/// A raw record without its slow drift: zeros before and behind it, 0.75 order / corner seconds each, then a
/// Butterworth high pass forwards and backwards (Boore 2005). The pads stay: velocity and displacement need
/// them to come to rest. What is permanent in the displacement goes with the drift.
/// @param corner Hz; @param order 1 to 12; as butterworth() demands; pads of 10^7 samples at most.
Accelerogram high_passed(const Accelerogram& record, double corner, int order);

/// A raw near-source record whose ground ends at rest, perhaps elsewhere (Iwan, Moser & Peng 1985): a line is
/// fitted to the velocity from `shift_end` to the end, and its slope subtracted there; the velocity that the
/// line has at `shift_end` is subtracted as a constant acceleration from `shift_start` to `shift_end`. What
/// is then left of the velocity at the end is taken off by a sin^2 pulse between the two instants, so that it
/// is zero.
/// @param shift_start, shift_end s, increasing, at least 3 samples apart and from the end; otherwise
/// std::invalid_argument.
Accelerogram correct_baseline_shift(const Accelerogram& record, double shift_start, double shift_end);

}  // namespace rockslope::record
