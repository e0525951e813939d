#pragma once

#include "common/base/input_error.hpp"
#include "dda/model/time_table.hpp"
#include "record/records.hpp"

namespace rockslope::dda {

/// What is done about the drift of an integrated record.
enum class Baseline { none, drift };

/// A record as the acceleration that a prescribed block follows, m/s2, times `scale`.
///
/// A velocity or a displacement is differentiated, see record::acceleration_samples().
/// @throws InputError at `place` when the record is too short for a spline (5 samples).
TimeTable acceleration_of(const record::Record& record, double scale, const SourceLocation& place);

/// The table with a last instant appended, one interval after its end, at which the acceleration is zero; the
/// table itself when it ends with zero or holds one instant. So the base's motion does not hang on how an
/// instant near the end was rounded.
TimeTable with_zero_end(const TimeTable& acceleration);

/// Where the engine's own update brings a base that starts from rest, v += dt a(t + dt), u += dt v_old + dt^2
/// a(t + dt) / 2, run in steps of `step` to the first instant at or past the table's end. Outside the table
/// the acceleration is zero.
struct FinalBaseState {
    double velocity = 0;      ///< m/s
    double displacement = 0;  ///< m
};
FinalBaseState integrate_base_motion(const TimeTable& acceleration, double step);

/// Subtracts the smallest correction, in the sense of least squares over the record, that brings the base
/// back to rest at zero displacement. The two end values are linear in a(t) with the weights 1 and (T - t),
/// so the smallest correction is a straight line c0 + c1 t; a last instant of zero acceleration stays so.
/// Exact for equal steps of `step`.
TimeTable baseline_corrected(const TimeTable& acceleration, double step);

}  // namespace rockslope::dda
