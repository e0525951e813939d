#include "record/correct.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "record/butterworth.hpp"

namespace rockslope::record {

namespace {

/// Coefficients of the polynomial in t / duration, fitted by least squares to the values from sample `first`
/// on.
Eigen::VectorXd fitted(const std::vector<double>& values, std::size_t first, int degree) {
    const auto rows = static_cast<Eigen::Index>(values.size() - first);
    const double last = static_cast<double>(values.size() - 1);
    Eigen::MatrixXd powers(rows, degree + 1);
    Eigen::VectorXd right(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const std::size_t k = first + row;
        right[row] = values[k];
        for (int power = 0; power <= degree; ++power)
            powers(row, power) = std::pow(static_cast<double>(k) / last, power);
    }
    return powers.householderQr().solve(right);
}

}  // namespace

Accelerogram without_mean(const Accelerogram& record, double until) {
    if (!(until >= 0) || !(until <= record.duration()))
        throw std::invalid_argument("the part before the event must lie within the record");
    const std::size_t count =
        until == 0 ? record.values.size() : static_cast<std::size_t>(std::lround(until / record.step)) + 1;
    const auto begin = record.values.begin();
    const double mean =
        std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(count), 0.0) / static_cast<double>(count);
    Accelerogram result = record;
    for (double& value : result.values) value -= mean;
    return result;
}

Accelerogram without_velocity_trend(const Accelerogram& record, int degree) {
    if (degree < 1 || degree > 3)
        throw std::invalid_argument("the degree of a trend must be between 1 and 3");
    if (record.values.size() < static_cast<std::size_t>(degree) + 2)
        throw std::invalid_argument("the record is too short for a trend of its velocity");
    const Eigen::VectorXd trend = fitted(integrate(record).velocity, 0, degree);
    Accelerogram result = record;
    const double last = static_cast<double>(record.values.size() - 1);
    for (std::size_t k = 0; k < result.values.size(); ++k)
        for (int power = 1; power <= degree; ++power)
            result.values[k] -=
                trend[power] * power * std::pow(static_cast<double>(k) / last, power - 1) / record.duration();
    return result;
}

Accelerogram high_passed(const Accelerogram& record, double corner, int order) {
    const auto filter = butterworth(Pass::high, order, corner, record.step);
    const double length = 0.75 * order / corner / record.step;
    if (!(length < 1e7))
        throw std::invalid_argument(
            "the corner frequency is too low: the padding would be 1e7 samples or more");
    const auto pad = static_cast<std::size_t>(std::ceil(length));
    std::vector<double> padded(record.values.size() + 2 * pad, 0.0);
    std::copy(record.values.begin(), record.values.end(), padded.begin() + static_cast<std::ptrdiff_t>(pad));
    return {record.step, filter_both_ways(filter, padded, 0)};
}

Accelerogram correct_baseline_shift(const Accelerogram& record, double shift_start, double shift_end) {
    const double dt = record.step;
    if (!(shift_start >= 0) || !(shift_end >= shift_start + 3 * dt) ||
        !(shift_end + 3 * dt <= record.duration()))
        throw std::invalid_argument(
            "the start and the end of a baseline shift must increase and lie within the record, at least 3 "
            "samples apart");
    const auto first = static_cast<std::size_t>(std::lround(shift_start / dt));
    const auto second = static_cast<std::size_t>(std::lround(shift_end / dt));
    const Eigen::VectorXd line = fitted(integrate(record).velocity, second, 1);
    const double end_fraction = static_cast<double>(second) / static_cast<double>(record.values.size() - 1);
    const double shift_duration = static_cast<double>(second - first) * dt;
    Accelerogram result = record;
    for (std::size_t k = first; k < result.values.size(); ++k)
        result.values[k] -=
            k < second ? (line[0] + line[1] * end_fraction) / shift_duration : line[1] / record.duration();
    // The mean of sin^2 over the interval is 1/2.
    const double final_velocity = integrate(result).velocity.back();
    for (std::size_t k = first; k < second; ++k) {
        const double sine =
            std::sin(std::numbers::pi * static_cast<double>(k - first) / static_cast<double>(second - first));
        result.values[k] -= 2 * final_velocity / shift_duration * sine * sine;
    }
    return result;
}

}  // namespace rockslope::record
