#include "record/baseline.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockslope::record {

namespace {

Accelerogram window_times_power(const Accelerogram& record, int power) {
    Accelerogram shape{record.step, std::vector<double>(record.values.size())};
    const double last = static_cast<double>(record.values.size() - 1);
    for (std::size_t k = 0; k < shape.values.size(); ++k) {
        const double fraction = static_cast<double>(k) / last;
        const double sine = std::sin(std::numbers::pi * fraction);
        shape.values[k] = sine * sine * (power == 0 ? 1.0 : fraction);
    }
    shape.values.back() = 0;
    return shape;
}

/// Velocity and displacement at the end.
Eigen::Vector2d final_motion(const Accelerogram& record) {
    const GroundMotion motion = integrate(record);
    return {motion.velocity.back(), motion.displacement.back()};
}

}  // namespace

Accelerogram correct_baseline(const Accelerogram& record) {
    if (record.values.size() < 4) {
        throw std::invalid_argument("a baseline correction needs at least 4 samples");
    }
    const Accelerogram constant = window_times_power(record, 0);
    const Accelerogram linear = window_times_power(record, 1);
    Eigen::Matrix2d effect;
    effect << final_motion(constant), final_motion(linear);
    const Eigen::FullPivLU<Eigen::Matrix2d> inverse(effect);

    // The second pass removes the rounding error of the first.
    Accelerogram corrected = record;
    for (int pass = 0; pass < 2; ++pass) {
        const Eigen::Vector2d coefficients = inverse.solve(final_motion(corrected));
        for (std::size_t k = 0; k < corrected.values.size(); ++k) {
            corrected.values[k] -= coefficients[0] * constant.values[k] + coefficients[1] * linear.values[k];
        }
    }
    return corrected;
}

}  // namespace rockslope::record
