#include "dda/io/base_acceleration.hpp"

#include <Eigen/LU>
#include <cmath>

#include "dda/record/differentiate.hpp"

namespace dda {

TimeTable acceleration_of(const Record& record, double scale, const blockgen::SourcePlace& place) {
    if (record.quantity != Quantity::acceleration && record.values.size() < least_differentiable)
        throw blockgen::InputError(place,
                                   "the record has " + std::to_string(record.values.size()) + " samples",
                                   "at least 5 to differentiate a " + quantity_name(record.quantity));
    std::vector<double> values = acceleration_samples(record);
    std::vector<double> times(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        times[i] = static_cast<double>(i) * record.dt;
        values[i] *= scale;
    }
    return ending_in_zero({std::move(times), std::move(values)});
}

TimeTable ending_in_zero(const TimeTable& acceleration) {
    std::vector<double> times = acceleration.times();
    std::vector<double> values = acceleration.values();
    if (times.size() < 2 || values.back() == 0) return acceleration;
    times.push_back(2 * times.back() - times[times.size() - 2]);
    values.push_back(0);
    return {std::move(times), std::move(values)};
}

BaseEnd integrate_base(const TimeTable& acceleration, double step) {
    const double end = acceleration.times().back();
    const long count = static_cast<long>(std::ceil(end / step * (1 - 1e-12)));
    BaseEnd base;
    for (long i = 1; i <= count; ++i) {
        const double time = static_cast<double>(i) * step;
        const double a = time > end || time < acceleration.times().front() ? 0.0 : acceleration.at(time);
        base.displacement += step * base.velocity + 0.5 * step * step * a;
        base.velocity += step * a;
    }
    return base;
}

TimeTable without_drift(const TimeTable& acceleration, double step) {
    const std::vector<double>& times = acceleration.times();
    const bool ends_in_zero = acceleration.values().back() == 0;
    std::vector<double> constant(times.size(), 1.0), linear(times.size());
    for (std::size_t i = 0; i < times.size(); ++i) linear[i] = times[i] / times.back();
    if (ends_in_zero) constant.back() = linear.back() = 0;

    const BaseEnd drift = integrate_base(acceleration, step);
    const BaseEnd of_constant = integrate_base({times, constant}, step);
    const BaseEnd of_linear = integrate_base({times, linear}, step);
    Eigen::Matrix2d effect;
    effect << of_constant.velocity, of_linear.velocity, of_constant.displacement, of_linear.displacement;
    const Eigen::Vector2d line = effect.inverse() * Eigen::Vector2d(drift.velocity, drift.displacement);

    std::vector<double> values = acceleration.values();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= line[0] * constant[i] + line[1] * linear[i];
    return {times, std::move(values)};
}

}  // namespace dda
