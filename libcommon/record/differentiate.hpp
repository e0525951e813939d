#pragma once

#include <vector>

#include "record/records.hpp"

namespace rockslope::record {

/// Samples that a record of velocity or displacement must have to be differentiated.
inline constexpr std::size_t min_spline_samples = 5;

/// The acceleration at a record's samples, m/s2: the record itself, or the first derivative of the cubic
/// spline through a velocity, the second of that through a displacement. A displacement starts from rest
/// (zero slope), so what it begins with is no jump.
/// @throws std::invalid_argument for a velocity or displacement of fewer than `min_spline_samples` samples.
std::vector<double> acceleration_samples(const Record& record);

/// The velocity at a record's samples, m/s: the record itself, the integral of an acceleration that is linear
/// between samples, from rest, or the derivative of the cubic spline through a displacement.
std::vector<double> velocity_samples(const Record& record);

}  // namespace rockslope::record
