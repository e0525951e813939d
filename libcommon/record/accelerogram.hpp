#pragma once

#include <vector>

namespace rockslope::record {

/// A ground acceleration sampled at the instants 0, step, 2 step, ...; linear between samples.
struct Accelerogram {
    double step = 0;             ///< s, positive
    std::vector<double> values;  ///< m/s2

    /// Time from the first sample to the last, s.
    double duration() const { return values.empty() ? 0 : step * static_cast<double>(values.size() - 1); }
};

/// Velocity and displacement of an accelerogram at its samples, from rest at the first one.
struct GroundMotion {
    std::vector<double> velocity;      ///< m/s
    std::vector<double> displacement;  ///< m
};

/// Integrates twice, exactly for an acceleration that is linear between samples.
GroundMotion integrate(const Accelerogram& record);

/// The largest absolute value; 0 if there is none.
double largest_magnitude(const std::vector<double>& values);

}  // namespace rockslope::record
