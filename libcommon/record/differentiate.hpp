#pragma once

#include <vector>

#include "record/records.hpp"

namespace rockslope::record {

/// Fewest samples of a record of velocity or displacement that can be differentiated.
inline constexpr std::size_t min_spline_samples = 5;

/// The acceleration at the samples of a record, m/s2: the record itself, the first derivative of the cubic
/// spline through a velocity, or the second derivative of that through a displacement. The spline of a
/// displacement starts with zero slope, so the motion starts without a jump.
/// @throws std::invalid_argument for a velocity or displacement of fewer than `min_spline_samples` samples.
std::vector<double> acceleration_samples(const Record& record);

/// The velocity at the samples of a record, m/s: the record itself, the integral from rest of an acceleration
/// that is linear between samples, or the derivative of the cubic spline through a displacement.
std::vector<double> velocity_samples(const Record& record);

}  // namespace rockslope::record
