#include "record/measures.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

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

/// The integral of |a|, exact for a linear acceleration between samples, m/s.
double absolute_integral(const Accelerogram& record) {
    double integral = 0;
    for (std::size_t k = 1; k < record.values.size(); ++k) {
        const double before = record.values[k - 1], after = record.values[k];
        const bool crosses = before * after < 0;
        integral += crosses ? (before * before + after * after) / std::abs(before - after) / 2
                            : std::abs(before + after) / 2;
    }
    return integral * record.step;
}

/// The band of the mean period, Hz, and the coarsest resolution of frequency [rathje1998].
constexpr double lowest_frequency = 0.25, highest_frequency = 20, frequency_resolution = 0.05;

double mean_period_of(const Accelerogram& record) {
    const auto padded = static_cast<std::size_t>(std::ceil(1 / (frequency_resolution * record.step)));
    std::vector<double> values = record.values;
    std::size_t count = 1;
    while (count < std::max(values.size(), padded)) count *= 2;
    values.resize(count);
    std::vector<std::complex<double>> amplitudes;
    Eigen::FFT<double>().fwd(amplitudes, values);
    double sum = 0, over_frequency = 0;
    for (std::size_t k = 1; k <= count / 2; ++k) {
        const double frequency = static_cast<double>(k) / (static_cast<double>(count) * record.step);
        if (frequency < lowest_frequency || frequency > highest_frequency) continue;
        const double square = std::norm(amplitudes[k]);
        sum += square;
        over_frequency += square / frequency;
    }
    return sum > 0 ? over_frequency / sum : 0;
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
    measures.cumulative_absolute_velocity = absolute_integral(record);
    measures.mean_period = mean_period_of(record);
    return measures;
}

}  // namespace rockslope::record
