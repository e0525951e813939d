#include "dda/input/base_acceleration.hpp"

#include <Eigen/LU>
#include <cmath>

#include "record/differentiate.hpp"

namespace rockslope::dda {

TimeTable acceleration_of(const record::Record& record, double scale, const SourceLocation& place) {
    if (record.quantity != record::Quantity::acceleration &&
        record.values.size() < record::min_spline_samples)
        throw InputError(place, "the record has " + std::to_string(record.values.size()) + " samples",
                         "at least 5 to differentiate a " + record::quantity_name(record.quantity));
    std::vector<double> values = record::acceleration_samples(record);
    std::vector<double> times(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        times[i] = static_cast<double>(i) * record.dt;
        values[i] *= scale;
    }
    return with_zero_end({std::move(times), std::move(values)});
}

TimeTable with_zero_end(const TimeTable& acceleration) {
    std::vector<double> times = acceleration.times();
    std::vector<double> values = acceleration.values();
    if (times.size() < 2 || values.back() == 0) return acceleration;
    times.push_back(2 * times.back() - times[times.size() - 2]);
    values.push_back(0);
    return {std::move(times), std::move(values)};
}

FinalBaseState integrate_base_motion(const TimeTable& acceleration, double step) {
    const double end = acceleration.times().back();
    const long count = static_cast<long>(std::ceil(end / step * (1 - 1e-12)));
    FinalBaseState base;
    for (long i = 1; i <= count; ++i) {
        const double time = static_cast<double>(i) * step;
        const double a = time > end || time < acceleration.times().front() ? 0.0 : acceleration.at(time);
        base.displacement += step * base.velocity + 0.5 * step * step * a;
        base.velocity += step * a;
    }
    return base;
}

TimeTable baseline_corrected(const TimeTable& acceleration, double step) {
    const std::vector<double>& times = acceleration.times();
    const bool ends_in_zero = acceleration.values().back() == 0;
    std::vector<double> constant(times.size(), 1.0), linear(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) linear[i] = times[i] / times.back();
    if (ends_in_zero) constant.back() = linear.back() = 0;

    const FinalBaseState drift = integrate_base_motion(acceleration, step);
    const FinalBaseState of_constant = integrate_base_motion({times, constant}, step);
    const FinalBaseState of_linear = integrate_base_motion({times, linear}, step);
    Eigen::Matrix2d effect;
    effect << of_constant.velocity, of_linear.velocity, of_constant.displacement, of_linear.displacement;
    const Eigen::Vector2d line = effect.inverse() * Eigen::Vector2d(drift.velocity, drift.displacement);

    std::vector<double> values = acceleration.values();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= line[0] * constant[i] + line[1] * linear[i];
    return {times, std::move(values)};
}

}  // namespace rockslope::dda
