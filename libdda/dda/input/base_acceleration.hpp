#pragma once

#include "common/base/input_error.hpp"
#include "dda/model/time_table.hpp"
#include "record/records.hpp"

namespace rockslope::dda {

/// Baseline correction of a record.
enum class Baseline { none, drift };

/// The acceleration of a record, m/s2, times `scale`. A velocity or a displacement is differentiated, see
/// record::acceleration_samples().
/// @throws InputError at `place` if the record is too short for a spline (5 samples).
TimeTable acceleration_of(const record::Record& record, double scale, const SourceLocation& place);

/// The table with a zero appended, one interval after its last entry. A table that ends with zero or has one
/// entry is returned unchanged. With the zero, the base's motion does not depend on the rounding of the time
/// of its last step.
TimeTable with_zero_end(const TimeTable& acceleration);

/// Velocity and displacement of a base after a record that starts from rest.
struct FinalBaseState {
    double velocity = 0;      ///< m/s
    double displacement = 0;  ///< m
};
/// The state of a base at the end of a record, from the update of the time integration, v += dt a(t + dt), u
/// += dt v_old + dt^2 a(t + dt) / 2. Steps of `step`, s, end with the first at or past the table's end.
/// Outside the table the acceleration is zero.
FinalBaseState integrate_base_motion(const TimeTable& acceleration, double step);

/// Baseline correction: subtracts the smallest correction, in the sense of least squares over the record,
/// that ends the motion of the base at rest with zero displacement. Both end values are linear in a(t), with
/// the weights 1 and (T - t), so the smallest correction is a straight line c0 + c1 t. A final zero of the
/// table stays zero. The correction is exact for equal steps of `step`, s.
TimeTable baseline_corrected(const TimeTable& acceleration, double step);

}  // namespace rockslope::dda
