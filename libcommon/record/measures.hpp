#pragma once

#include "record/accelerogram.hpp"

namespace rockslope::record {

inline constexpr double standard_gravity = 9.80665;  // m/s2

/// Intensity measures of a record.
struct RecordMeasures {
    double peak_acceleration = 0;     ///< m/s2
    double peak_velocity = 0;         ///< m/s
    double peak_displacement = 0;     ///< m
    double final_velocity = 0;        ///< m/s, signed
    double final_displacement = 0;    ///< m, signed
    double arias_intensity = 0;       ///< m/s, pi / (2 g) times the integral of a^2 (Arias 1970)
    double significant_duration = 0;  ///< s, from 5 % to 95 % of the Arias intensity (Trifunac & Brady 1975)
    double significant_duration_75 = 0;       ///< s, from 5 % to 75 %
    double cumulative_absolute_velocity = 0;  ///< m/s, the integral of |a| (EPRI 1988)
    double mean_period =
        0;  ///< s, Fourier amplitudes squared over f, over their sum, 0.25 to 20 Hz (Rathje et al. 1998)
};

/// @param record at least one sample.
RecordMeasures measure(const Accelerogram& record);

}  // namespace rockslope::record
