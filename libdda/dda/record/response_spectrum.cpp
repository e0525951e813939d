#include "dda/record/response_spectrum.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dda {

namespace {

/// The step of the oscillator: (u, v) after = transition (u, v) before + load (a before, a after).
struct StepMatrices {
    Eigen::Matrix2d transition;
    Eigen::Matrix2d load;
};

/// Under a(t) = a0 + s t, s = (a1 - a0) / h, a particular solution is u_p(t) = c + d t with d = -s / w^2 and
/// c = -a0 / w^2 + 2 z s / w^3. What differs from it at the step's start decays freely, by `transition`:
///   x(h) = transition (x(0) - x_p(0)) + x_p(h).
StepMatrices step_matrices(double frequency, double damping, double h) {
    const double damped = frequency * std::sqrt(1 - damping * damping);
    const double decay = std::exp(-damping * frequency * h);
    const double cosine = decay * std::cos(damped * h);
    const double sine = decay * std::sin(damped * h) / damped;
    StepMatrices step;
    step.transition << cosine + damping * frequency * sine, sine, -frequency * frequency * sine,
        cosine - damping * frequency * sine;

    const double stiffness = frequency * frequency;
    const double slope = 1 / (h * stiffness);
    const double lag = 2 * damping / (frequency * h * stiffness);
    // Columns: the particular solution at the step's start for a unit a before, and for a unit a after.
    Eigen::Matrix2d at_start;
    at_start << -1 / stiffness - lag, lag, slope, -slope;
    Eigen::Matrix2d at_end = at_start;
    at_end.row(0) += h * at_start.row(1);
    step.load = at_end - step.transition * at_start;
    return step;
}

Accelerogram resampled(const Accelerogram& record, int parts) {
    if (parts <= 1 || record.values.empty()) {
        return record;
    }
    Accelerogram fine{record.step / parts, {}};
    fine.values.reserve((record.values.size() - 1) * static_cast<std::size_t>(parts) + 1);
    for (std::size_t k = 0; k + 1 < record.values.size(); ++k) {
        for (int i = 0; i < parts; ++i) {
            fine.values.push_back(
                std::lerp(record.values[k], record.values[k + 1], static_cast<double>(i) / parts));
        }
    }
    fine.values.push_back(record.values.back());
    return fine;
}

}  // namespace

OscillatorMotion oscillate(const Accelerogram& record, double period, double damping) {
    if (!(period > 0) || !(damping >= 0 && damping < 1)) {
        throw std::invalid_argument("an oscillator needs a positive period and a damping in [0, 1)");
    }
    const double frequency = 2 * std::numbers::pi / period;
    const StepMatrices step = step_matrices(frequency, damping, record.step);
    const std::size_t count = record.values.size();
    OscillatorMotion motion{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
                            std::vector<double>(count, 0.0)};
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    for (std::size_t k = 1; k < count; ++k) {
        const Eigen::Vector2d ground(record.values[k - 1], record.values[k]);
        state = step.transition * state + step.load * ground;
        motion.displacement[k] = state[0];
        motion.velocity[k] = state[1];
        motion.absolute_acceleration[k] = -frequency * (frequency * state[0] + 2 * damping * state[1]);
    }
    return motion;
}

std::vector<SpectralOrdinate> response_spectrum(const Accelerogram& record, std::span<const double> periods,
                                                double damping) {
    std::vector<SpectralOrdinate> spectrum;
    for (const double period : periods) {
        const int parts = static_cast<int>(std::ceil(20 * record.step / period));
        const OscillatorMotion motion = oscillate(resampled(record, parts), period, damping);
        spectrum.push_back({period, largest_magnitude(motion.displacement),
                            largest_magnitude(motion.velocity),
                            largest_magnitude(motion.absolute_acceleration)});
    }
    return spectrum;
}

}  // namespace dda
