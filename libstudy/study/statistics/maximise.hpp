#pragma once

#include <Eigen/Dense>

#include "study/statistics/lognormal_curve.hpp"

namespace rockslope::study {

/// A log-likelihood of N parameters at a point, with its derivatives.
template <int N>
struct LogLikelihood {
    double value = 0;
    Eigen::Vector<double, N> gradient = Eigen::Vector<double, N>::Zero();
    Eigen::Matrix<double, N, N> curvature =
        Eigen::Matrix<double, N, N>::Zero();  ///< negative of the second derivatives

    /// Adds `count` rows of the probability Phi(direction . at).
    void add_normal(double count, const Eigen::Vector<double, N>& direction,
                    const Eigen::Vector<double, N>& at) {
        if (count == 0) return;
        const double z = direction.dot(at);
        const double ratio = inverse_mills_ratio(z);
        value += count * log_normal_cdf(z);
        gradient += count * ratio * direction;
        curvature += count * ratio * (z + ratio) * direction * direction.transpose();
    }
};

/// The maximum of a concave log-likelihood by Newton's method; a step that lowers it, or leaves its domain,
/// is halved. @param likelihood gives a LogLikelihood at a point; @param is_inside whether a point is in its
/// domain.
template <int N, class Likelihood, class Domain>
Eigen::Vector<double, N> maximise(Eigen::Vector<double, N> at, const Likelihood& likelihood,
                                  const Domain& is_inside) {
    constexpr int most_newton_steps = 200;
    constexpr double smallest_newton_step = 1e-13;  // over the parameters' size
    LogLikelihood<N> here = likelihood(at);
    for (int k = 0; k < most_newton_steps; ++k) {
        Eigen::Vector<double, N> step = here.curvature.ldlt().solve(here.gradient);
        const auto is_small = [&] { return !(step.norm() > smallest_newton_step * (1 + at.norm())); };
        if (!step.allFinite() || is_small()) break;
        while (!is_inside(at + step) && !is_small()) step /= 2;
        LogLikelihood<N> there = likelihood(at + step);
        while (!(there.value >= here.value) && !is_small()) {
            step /= 2;
            there = likelihood(at + step);
        }
        at += step;
        here = there;
    }
    return at;
}

}  // namespace rockslope::study
