#pragma once

#include <string>

#include "record/accelerogram.hpp"

namespace rockslope {

/// Summary of a record in plain text: sampling, peaks, Arias intensity, significant durations, and velocity
/// and displacement at the end.
std::string measures_text(const record::Accelerogram& record);

/// The response spectrum as CSV, 61 periods from 0.02 s to 6.3 s, accelerations in g.
std::string spectrum_text(const record::Accelerogram& record, double damping);

}  // namespace rockslope
