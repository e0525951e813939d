#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "dda/joint/barton_bandis.hpp"
#include "dda/joint/cyclic_barton_bandis.hpp"
#include "support/scene.hpp"

namespace rockslope::scene {

/// Where a block on a shaken joint is.
struct Expected {
    double time = 0;  ///< s, of shaking
    double slip = 0;  ///< m, down the plane
    double rise = 0;  ///< m, normal to it
};

/// A block on a rough joint, which is shaken along a plane.
struct Shaken {
    double psi = 0;  ///< deg, dip of the plane
    dda::JointLaw law;
    double width = 0, height = 0, density = 0;   ///< m, m, kg/m3
    std::function<double(double)> acceleration;  ///< m/s2, horizontal, of the base
    double step = 0;                             ///< s
    std::vector<Expected> expected;
    double shear_stiffness = 0;  ///< Pa/m, of the joint; 0: that of the law, or as stiff as the normal spring
    std::function<double(double)> vertical = {};  ///< m/s2, of the base, if it moves so
    double contact_damping = 0;                   ///< of the joint
    double largest_open_share = 0.01;             ///< of the steps

    Scene scene() const {
        const double angle = -radians(psi);
        const Vec2 along(std::cos(angle), std::sin(angle));
        Scene s;
        s.model.joint_materials[0].law = law;
        s.model.joint_materials[0].shear_stiffness = shear_stiffness;
        s.model.joint_materials[0].contact_damping = contact_damping;
        s.model.block_materials[0].density = density;
        s.model.block_materials[0].youngs_modulus = 1e13;
        s.model.normal_penalty = s.model.shear_penalty = 5e10 * width / 2;
        s.box(-height * dda::perpendicular(along) - width * along, 3 * width, height, dda::Motion::prescribed,
              angle, "base");
        s.box({0, 0}, width, height, dda::Motion::free, angle);
        return s;
    }
    dda::TimeTable table(const std::function<double(double)>& motion) const {
        std::vector<double> times, values;
        for (int k = 0; k <= 1000 * expected.back().time + 1; ++k) {
            times.push_back(1e-3 * k);
            values.push_back(motion(times.back()));
        }
        return {times, values};
    }
    dda::Stage shaking() const {
        dda::Stage stage;
        stage.name = "shaking";
        stage.duration = expected.back().time;
        stage.control.step = step;
        stage.base_motions.push_back({"base", table(acceleration), {}});
        if (vertical) stage.base_motions.back().y = table(vertical);
        return stage;
    }
    /// The slip when the shaking ends, m.
    double slip_at_the_end() const {
        Simulation sim(scene());
        EXPECT_EQ(sim.settle().status, dda::RunStatus::completed);
        const Vec2 settled = sim.moved(1) - sim.moved(0);
        EXPECT_EQ(sim.run(shaking()).status, dda::RunStatus::completed);
        return (sim.moved(1) - sim.moved(0) - settled).norm();
    }

    /// Slip and rise within 2 % of the reference, always in contact, and no friction that returns energy.
    void expect_the_reference() const {
        Simulation sim(scene());
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        const dda::Stage stage = shaking();
        const Vec2 downhill(std::cos(radians(psi)), -std::sin(radians(psi)));
        const Vec2 settled = sim.moved(1) - sim.moved(0);
        std::size_t next = 0;
        int steps = 0, open_steps = 0;
        double highest = -1e300, largest_fall = 0, friction = 0;
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
            const Vec2 moved = sim.moved(1) - sim.moved(0) - settled;
            const auto is_open = [](const dda::Contact& c) { return c.state == dda::ContactState::open; };
            ++steps;
            open_steps +=
                std::all_of(state.contacts.contacts.begin(), state.contacts.contacts.end(), is_open);
            friction = state.energy.friction_loss;
            highest = std::max(highest, friction);
            largest_fall = std::max(largest_fall, highest - friction);
            while (next < expected.size() && state.stage_time > expected[next].time - 1e-9) {
                const Expected& here = expected[next++];
                EXPECT_NEAR(moved.dot(downhill), here.slip, 0.02 * std::abs(here.slip)) << here.time;
                EXPECT_NEAR(moved.dot(dda::perpendicular(downhill)), here.rise, 0.02 * here.rise)
                    << here.time;
            }
        };
        ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        EXPECT_EQ(next, expected.size());
        EXPECT_LE(open_steps, largest_open_share * steps);
        EXPECT_GT(friction, 0);
        EXPECT_LT(largest_fall, 1e-5 * friction) << "friction returns energy";
        EXPECT_LT(sim.state.energy.friction_returned, 1e-5 * friction);
        EXPECT_LT(std::abs(sim.state.energy.residual()), 1e-3 * friction);
    }
};

/// A joint whose roughness neither wears nor changes with the distance.
inline dda::CyclicBartonBandis even(double jrc, double residual_degrees) {
    dda::CyclicBartonBandis law;
    law.barton = {jrc, 50e6, radians(residual_degrees)};
    law.peak_displacement = 2e-3;
    law.damage = 1;
    const dda::RoughnessTable wear = {{{0, 1}, {1, 1}}};
    law.cycles = {{wear, wear, wear, wear}};
    law.unsigned_ratios = true;
    return law;
}

/// Half a sine, m/s2.
inline double pulse(double t, double peak, double duration) {
    return t < duration ? peak * std::sin(std::numbers::pi * t / duration) : 0;
}

/// A vertical kick that throws the block: 2 g up for 10 ms from 0.3 s on, and back down in the 20 ms after
/// it.
inline double kick(double t) {
    using std::numbers::pi;
    if (t > 0.30 && t < 0.31) return 2 * g * std::sin(pi * (t - 0.30) / 0.01);
    if (t > 0.31 && t < 0.33) return -2 * g * std::sin(pi * (t - 0.31) / 0.02);
    return 0;
}

/// The mobilisation of Barton (1985).
inline dda::BartonBandis mobilised() {
    dda::BartonBandis law;
    law.barton = {2, 50e6, radians(18)};
    law.peak_displacement = 2e-3;
    law.mobilisation = dda::barton_1985();
    law.from_zero_angle = true;
    law.damage = 1;
    return law;
}

}  // namespace rockslope::scene
