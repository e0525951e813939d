#include "record/response_spectrum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rockslope::record {

namespace {

/// One step of the oscillator: (u, v) after = transition (u, v) before + load (a before, a after).
struct StepMatrices {
    Eigen::Matrix2d transition;
    Eigen::Matrix2d load;
};

/// Under a(t) = a0 + s t, s = (a1 - a0) / h, a particular solution is u_p(t) = c + d t with d = -s / w^2 and
/// c = -a0 / w^2 + 2 z s / w^3. The difference from it at the start of the step decays freely, by
/// `transition`:
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
    // Columns: the particular solution at the start of the step for a0 = 1, a1 = 0 and for a0 = 0, a1 = 1.
    Eigen::Matrix2d at_start;
    at_start << -1 / stiffness - lag, lag, slope, -slope;
    Eigen::Matrix2d at_end = at_start;
    at_end.row(0) += h * at_start.row(1);
    step.load = at_end - step.transition * at_start;
    return step;
}

/// Calls visit(displacement, velocity, absolute acceleration) at the start and after each of `substeps` steps
/// between samples.
template <class Visit>
void time_march(const Accelerogram& record, double period, double damping, int substeps, const Visit& visit) {
    if (!(period > 0) || !(damping >= 0 && damping < 1)) {
        throw std::invalid_argument("an oscillator needs a positive period and a damping in [0, 1)");
    }
    const double frequency = 2 * std::numbers::pi / period;
    const StepMatrices step = step_matrices(frequency, damping, record.step / substeps);
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    const auto visit_state = [&] {
        visit(state[0], state[1], -frequency * (frequency * state[0] + 2 * damping * state[1]));
    };
    if (!record.values.empty()) visit_state();
    for (std::size_t k = 1; k < record.values.size(); ++k) {
        for (int i = 0; i < substeps; ++i) {
            const auto ground = [&](int part) {
                return std::lerp(record.values[k - 1], record.values[k],
                                 static_cast<double>(part) / substeps);
            };
            state = step.transition * state + step.load * Eigen::Vector2d(ground(i), ground(i + 1));
            visit_state();
        }
    }
}

}  // namespace

OscillatorMotion oscillate(const Accelerogram& record, double period, double damping) {
    OscillatorMotion motion;
    time_march(record, period, damping, 1, [&](double displacement, double velocity, double acceleration) {
        motion.displacement.push_back(displacement);
        motion.velocity.push_back(velocity);
        motion.absolute_acceleration.push_back(acceleration);
    });
    return motion;
}

std::vector<SpectralOrdinate> response_spectrum(const Accelerogram& record, std::span<const double> periods,
                                                double damping) {
    std::vector<SpectralOrdinate> spectrum;
    for (const double period : periods) {
        const int substeps = std::max(1, static_cast<int>(std::ceil(20 * record.step / period)));
        SpectralOrdinate largest{period, 0, 0, 0};
        time_march(record, period, damping, substeps, [&](double u, double v, double a) {
            largest.displacement = std::max(largest.displacement, std::abs(u));
            largest.velocity = std::max(largest.velocity, std::abs(v));
            largest.absolute_acceleration = std::max(largest.absolute_acceleration, std::abs(a));
        });
        spectrum.push_back(largest);
    }
    return spectrum;
}

}  // namespace rockslope::record
