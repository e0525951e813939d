#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// Acceleration as a function of time, m/s2.
using Acceleration = std::function<double(double)>;

/// The acceleration times `sign`, in samples every 0.5 ms: the error for a sine of 2 Hz is 5e-6.
inline dda::TimeTable sampled(const Acceleration& acceleration, double duration, double sign = 1) {
    std::vector<double> times;
    std::vector<double> values;
    const int samples = static_cast<int>(std::lround(duration / 5e-4));
    for (int k = 0; k <= samples; ++k) {
        times.push_back(k * 5e-4);
        values.push_back(sign * acceleration(times.back()));
    }
    return {times, values};
}

/// Position along the slope against time.
struct Track {
    std::vector<double> time;  ///< s
    std::vector<double> slip;  ///< m, downhill relative to the base

    /// Linear interpolation; the track must reach `t`.
    double at(double t) const {
        const auto after = std::lower_bound(time.begin(), time.end(), t - 1e-9);
        const auto k = static_cast<std::size_t>(after - time.begin());
        if (k == 0 || time.at(k) == t) return slip.at(k);
        const double fraction = (t - time[k - 1]) / (time[k] - time[k - 1]);
        return slip[k - 1] + fraction * (slip[k] - slip[k - 1]);
    }
    verification::Curve curve(const std::string& name) const { return {name, time, slip}; }
};

/// Newmark's sliding block, integrated to convergence. In the frame of the base a unit mass has the driving
/// force w sin(psi) - a cos(psi) downhill and the friction tan(phi) (w cos(psi) + a sin(psi)) against its
/// velocity, with a the horizontal acceleration of the base, positive downhill, and w = g plus its upward
/// acceleration `vertical`, if it has one. Explicit steps of 1e-5 s with the acceleration at mid-step; a
/// velocity that would change sign in a step becomes zero.
inline Track sliding_reference(double psi_degrees, double phi_degrees, const Acceleration& base,
                               double duration, const Acceleration& vertical = {}) {
    const double psi = radians(psi_degrees);
    const double mu = std::tan(radians(phi_degrees));
    const double dt = 1e-5;
    const int kept_every = 100;
    Track track{{0}, {0}};
    double v = 0;
    double s = 0;
    const int steps = static_cast<int>(std::lround(duration / dt));
    for (int k = 1; k <= steps; ++k) {
        const double a = base((k - .5) * dt);
        const double w = vertical ? g + vertical((k - .5) * dt) : g;
        const double drive = w * std::sin(psi) - a * std::cos(psi);
        const double strength = mu * (w * std::cos(psi) + a * std::sin(psi));
        double next = 0;
        if (v != 0) {
            next = v + dt * (drive - std::copysign(strength, v));
            if (next * v < 0) next = 0;
        } else if (std::abs(drive) > strength) {
            next = dt * (drive - std::copysign(strength, drive));
        }
        s += dt * (v + next) / 2;
        v = next;
        if (k % kept_every == 0) {
            track.time.push_back(k * dt);
            track.slip.push_back(s);
        }
    }
    return track;
}

/// The way in which the shaking is applied to the block.
enum class Shaking { moving_base, body_force, frame };

/// A block, 2 m long and 1 m high, on an incline that dips to the right. It settles with high friction and is
/// then shaken.
struct SlidingBlock {
    double psi = 0;  ///< degrees
    double phi = 0;  ///< degrees
    Acceleration base{};
    Shaking shaking = Shaking::moving_base;
    double damping_ratio = 0.1;  ///< of the block's strain modes

    Acceleration vertical{};  ///< of the base, positive up; none: it moves horizontally

    double base_speed = 0;  ///< m/s, of the base at the start, positive downhill and horizontal

    Track track{};
    double stopped = 0;   ///< s, last time at which it moved faster than 1 mm/s
    double fastest = 0;   ///< m/s, relative to the base
    double started = -1;  ///< s, first time at which it moved faster than 1 mm/s; -1: never
    double frequency_step = 0;

    /// Runs DDA for `duration` in steps of `step`, s, and records the energy balance of the case.
    void run(const std::string& id, const std::string& set_up, double duration, double step);

  private:
    Scene scene(double friction_degrees) const;
};

inline Scene SlidingBlock::scene(double friction_degrees) const {
    const double angle = -radians(psi);
    const Vec2 along(std::cos(angle), std::sin(angle));
    Scene s;
    s.friction(friction_degrees);
    s.model.block_materials[0].damping_ratio = damping_ratio;
    s.box(-dda::perpendicular(along) - 10 * along, 30, 1, dda::Motion::prescribed, angle, "base");
    s.box({0, 0}, 2, 1, dda::Motion::free, angle);
    return s;
}

inline void SlidingBlock::run(const std::string& id, const std::string& set_up, double duration,
                              double step) {
    const Scene glued = scene(80);
    Simulation settled(glued);
    ASSERT_EQ(settled.settle().status, dda::RunStatus::completed);

    Scene s = scene(phi);
    dda::Stage stage;
    stage.name = "shaking";
    stage.duration = duration;
    stage.control.step = step;
    if (shaking == Shaking::moving_base) {
        stage.base_motions.push_back({"base", sampled(base, duration), {}});
        if (vertical) stage.base_motions.back().y = sampled(vertical, duration);
    } else if (shaking == Shaking::frame) {
        stage.frame_motions.push_back({"", sampled(base, duration), {}});
    } else {
        s.model.loads.push_back(dda::BodyLoad{1, {1, 0}, sampled(base, duration, -1)});
    }
    Simulation sim(s);
    sim.state = settled.state;
    sim.velocity(0)[0] = base_speed;
    sim.restart_ledger();
    const Vec2 downhill(std::cos(radians(psi)), -std::sin(radians(psi)));
    track = {{0}, {0}};
    double next_kept = 0;
    sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
        const double speed =
            (state.blocks.velocity[1].head<2>() - state.blocks.velocity[0].head<2>()).dot(downhill);
        fastest = std::max(fastest, std::abs(speed));
        if (std::abs(speed) > 1e-3) {
            stopped = state.stage_time;
            if (started < 0) started = state.stage_time;
        }
        if (state.stage_time < next_kept && state.stage_time < duration - 1e-9) return;
        next_kept += 1e-3;
        track.time.push_back(state.stage_time);
        track.slip.push_back((sim.moved(1) - sim.moved(0)).dot(downhill));
    };
    ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
    frequency_step = sim.contact_frequency_step();
    verification::expect_energy_balance(id, set_up, sim);
}

}  // namespace rockslope::scene
