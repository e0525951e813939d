#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "support/scene.hpp"

namespace rockslope::scene {

/// A slender block on a rigid base, as Housner idealised it. It rotates about one of its lower corners and
/// does not slide. Each impact multiplies its angular velocity by e = 1 - 3/2 sin^2(alpha). With theta > 0
/// about the left corner and s the sign of theta, theta'' = -p^2 (sin(alpha s - theta) - a/g cos(alpha s -
/// theta)), p^2 = 3 g/(4 R), with R half the diagonal and a the acceleration of the base to the right.
class HousnerBlock {
  public:
    HousnerBlock(double width, double height)
        : alpha_(std::atan2(width, height)), p2_(3 * g / (2 * std::hypot(width, height))) {}

    double alpha() const { return alpha_; }
    double restitution() const { return 1 - 1.5 * std::sin(alpha_) * std::sin(alpha_); }

    struct Motion {
        std::vector<double> time, angle;
        std::vector<double> impacts;       ///< s
        std::vector<double> impact_speed;  ///< rad/s, before the impact
        bool overturned = false;
    };
    /// Integrates by the classical Runge-Kutta method in steps of `dt`. The time of an impact is interpolated
    /// linearly. A block at rest stays while |a| < g tan(alpha).
    Motion release(double angle, const std::function<double(double)>& base, double duration,
                   double dt = 1e-4) const {
        Motion motion{{0}, {angle}, {}, {}, false};
        double theta = angle;
        double omega = 0;
        const int steps = static_cast<int>(std::lround(duration / dt));
        for (int k = 0; k < steps; ++k) {
            const double t = k * dt;
            if (theta == 0 && omega == 0 && std::abs(base(t)) <= g * std::tan(alpha_)) continue;
            const double side = theta != 0 ? theta : omega != 0 ? omega : base(t);
            const auto angular_acceleration = [&](double time, double th) {
                const double lever = std::copysign(alpha_, side) - th;
                return -p2_ * (std::sin(lever) - base(time) / g * std::cos(lever));
            };
            const double before = theta;
            const double speed_before = omega;
            runge_kutta(angular_acceleration, t, dt, theta, omega);
            if (before != 0 && theta * before <= 0) {
                const double fraction = before / (before - theta);
                motion.impacts.push_back(t + fraction * dt);
                omega = speed_before + fraction * (omega - speed_before);
                motion.impact_speed.push_back(std::abs(omega));
                omega *= restitution();
                theta = (1 - fraction) * dt * omega;
            }
            motion.time.push_back(t + dt);
            motion.angle.push_back(theta);
            if (std::abs(theta) > std::numbers::pi / 2) {
                motion.overturned = true;
                break;
            }
        }
        return motion;
    }

  private:
    template <class Turned>
    static void runge_kutta(const Turned& turned, double t, double dt, double& theta, double& omega) {
        const double a1 = turned(t, theta);
        const double w2 = omega + dt / 2 * a1;
        const double a2 = turned(t + dt / 2, theta + dt / 2 * omega);
        const double w3 = omega + dt / 2 * a2;
        const double a3 = turned(t + dt / 2, theta + dt / 2 * w2);
        const double w4 = omega + dt * a3;
        const double a4 = turned(t + dt, theta + dt * w3);
        theta += dt / 6 * (omega + 2 * w2 + 2 * w3 + w4);
        omega += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    double alpha_;
    double p2_;
};

/// The same block computed by DDA, on a base that may move. With friction of 60 degrees it does not slide.
struct RockingBlock {
    double width = 0;
    double height = 0;
    double step = 4e-5;
    double damping_ratio = 0.1;

    std::vector<double> time, angle;
    std::vector<double> impacts;       ///< s, of the raised corner
    std::vector<double> impact_speed;  ///< rad/s, in the step before the impact
    double frequency_step = 0;
    std::optional<EnergyMonitor> energy;

    /// Releases the block from a tilt `angle0`, rad, about its left corner, on which it has settled with its
    /// top fixed horizontally; or, without a tilt, shakes its base.
    void run(double angle0, const dda::TimeTable& base, double duration) {
        Scene s;
        s.friction(60);
        s.model.block_materials[0].damping_ratio = damping_ratio;
        s.box({-5 * height, -1}, 10 * height, 1, dda::Motion::prescribed, 0, "base");
        const int block = s.box({0, 0}, width, height, dda::Motion::free, angle0);
        const int top = s.material_point(block, s.model.vertices.back());
        Scene held = s;
        if (angle0 != 0) held.model.fixed_points.push_back({top, true, false});
        Simulation settled(held);
        ASSERT_EQ(settled.settle().status, dda::RunStatus::completed);

        Simulation sim(s);
        sim.state = settled.state;
        sim.restart_ledger();
        dda::Stage stage;
        stage.name = "rocking";
        stage.duration = duration;
        stage.control.step = step;
        if (!base.empty()) stage.base_motions.push_back({"base", base, {}});
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) { observe(state); };
        ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        frequency_step = sim.contact_frequency_step();
        energy = sim.energy;
    }
    /// Largest angle, rad.
    double largest_angle() const {
        double largest = 0;
        for (const double theta : angle) largest = std::max(largest, std::abs(theta));
        return largest;
    }

  private:
    /// Records the angle and detects impacts by the sign of the angle.
    void observe(const dda::State& state) {
        const double theta = std::atan2(state.blocks.vertices[5].y() - state.blocks.vertices[4].y(),
                                        state.blocks.vertices[5].x() - state.blocks.vertices[4].x());
        const double omega = state.blocks.velocity[1][2];
        if (!angle.empty() && theta * angle.back() <= 0 && std::abs(omega_) > 1e-2) {
            const double fraction = angle.back() / (angle.back() - theta);
            impacts.push_back(time.back() + fraction * (state.stage_time - time.back()));
            impact_speed.push_back(std::abs(omega_));
        }
        time.push_back(state.stage_time);
        angle.push_back(theta);
        omega_ = omega;
    }
    double omega_ = 0;
};

}  // namespace rockslope::scene
