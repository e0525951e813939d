#include "record/measures.hpp"

#include <algorithm>
#include <numbers>

namespace rockslope::record {

namespace {

/// The integral of a^2 up to each sample, exact for a linear acceleration between samples, m2/s3.
std::vector<double> squared_integral(const Accelerogram& record) {
    std::vector<double> integral(record.values.size(), 0.0);
    for (std::size_t k = 1; k < integral.size(); ++k) {
        const double before = record.values[k - 1];
        const double after = record.values[k];
        integral[k] = integral[k - 1] + record.step * (before * before + before * after + after * after) / 3;
    }
    return integral;
}

/// The time, s, at which the integral reaches a fraction of its final value.
double time_of_fraction(const std::vector<double>& integral, double fraction, double step) {
    const auto first = std::lower_bound(integral.begin(), integral.end(), fraction * integral.back());
    return step * static_cast<double>(first - integral.begin());
}

}  // namespace

RecordMeasures measure(const Accelerogram& record) {
    const GroundMotion motion = integrate(record);
    const std::vector<double> integral = squared_integral(record);
    RecordMeasures measures;
    measures.peak_acceleration = largest_magnitude(record.values);
    measures.peak_velocity = largest_magnitude(motion.velocity);
    measures.peak_displacement = largest_magnitude(motion.displacement);
    measures.final_velocity = motion.velocity.back();
    measures.final_displacement = motion.displacement.back();
    measures.arias_intensity = std::numbers::pi / (2 * standard_gravity) * integral.back();
    const auto since_five_percent = [&](double fraction) {
        return time_of_fraction(integral, fraction, record.step) -
               time_of_fraction(integral, 0.05, record.step);
    };
    measures.significant_duration = since_five_percent(0.95);
    measures.significant_duration_75 = since_five_percent(0.75);
    return measures;
}

}  // namespace rockslope::record
