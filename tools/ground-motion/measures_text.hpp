#pragma once

#include <string>

#include "dda/record/accelerogram.hpp"

/// Sampling, peaks, Arias intensity, significant durations and where the ground ends, for reading.
std::string measures_text(const dda::Accelerogram& record);

/// The response spectrum as CSV, 61 periods from 0.02 s to 6.3 s, accelerations in g.
std::string spectrum_text(const dda::Accelerogram& record, double damping);
