// Waves in chains of bonded blocks.

#include <gtest/gtest.h>

#include "support/bar.hpp"
#include "support/case_name.hpp"
#include "support/energy_balance.hpp"
#include "support/record.hpp"

namespace rockslope::waves_test {
namespace {

using namespace scene;
using namespace verification;

enum class Sides { free, confined, sheared };

struct SpeedCase {
    const char* name;
    dda::Plane plane;
    Sides sides;
    double speed;
};
class WaveSpeed : public testing::TestWithParam<SpeedCase> {};

// V30. Blocks of 0.1 m, 20 to the length of the pulse. The speeds are sqrt(modulus/density), with the moduli
// E, E/(1 - nu^2), the one without lateral strain, and G. A bonded chain of constant-strain blocks is a chain
// of linear finite elements with consistent mass: too fast by (2 pi/20)^2/24 = 0.4 % at that length. The
// joints slow the wave by 0.05 %.
TEST_P(WaveSpeed, IsThatOfTheBar) {
    const SpeedCase& c = GetParam();
    Bar bar(200, 0.1, c.plane, c.sides == Sides::free ? Bar::free : Bar::glued);
    const int axis = c.sides == Sides::sheared ? 1 : 0;
    if (c.sides == Sides::confined) bar.hold(false, true);
    if (c.sides == Sides::sheared) bar.hold(true, false);
    const double pulse = 20 * bar.block_length / c.speed;
    bar.push(1e6 * Vec2::Unit(axis), raised_cosine(pulse));
    Simulation sim(bar.s);
    const Seismogram record(sim, {49, 149}, axis);
    ASSERT_EQ(sim.run(wave_stage(17 / c.speed, 0.02 * pulse)).status, dda::RunStatus::completed);
    const double speed = 100 * bar.block_length / (record.arrival(1) - record.arrival(0));
    const std::string set_up = std::string(c.name) + ", 200 blocks of 0.1 m, pulse of 20 blocks";
    const Case row = Case("V30", set_up, "dispersion of constant-strain blocks, 0.4 % at this length")
                         .contact_frequency_step(sim.contact_frequency_step());
    row.expect("speed", "m/s", speed, c.speed, relative(0.006));
    // Pressure is density times speed times velocity.
    row.expect("peak after 15 m", "m/s", record.largest(1), 1e6 / (bar.density() * c.speed), relative(0.01));
    expect_energy_balance("V30", set_up, sim);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WaveSpeed,
                         testing::Values(SpeedCase{"bar", dda::Plane::stress, Sides::free, 2000.0},
                                         SpeedCase{"plate", dda::Plane::strain, Sides::free, 2065.6},
                                         SpeedCase{"confined", dda::Plane::strain, Sides::confined, 2190.9},
                                         SpeedCase{"shear", dda::Plane::strain, Sides::sheared, 1264.9}),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

class JointedColumn : public testing::TestWithParam<double> {};

// P15. Waves much longer than a block see the joints as compliance: 1/E_eff = 1/E + 1/(k h). The chain
// disperses by at most (2 pi/ 80)^2/24 = 0.03 % of blocks to the length, and the integration by (2
// pi/100)^2/12 = 0.03 %.
TEST_P(JointedColumn, CarriesWavesAtTheSpeedOfItsJointsAndRock) {
    const double stiffness = GetParam();  // k h/E
    Bar column(420, 0.1, dda::Plane::stress);
    const double unit = 10e9 / column.block_length;
    column.s.model.joint_materials[0] = elastic_joint(stiffness * unit, Bar::free * unit);
    const double speed = std::sqrt(10e9 / (1 + 1 / stiffness) / column.density());
    const double pulse = 80 * column.block_length / speed;
    column.push({1e6, 0}, raised_cosine(pulse));
    Simulation sim(column.s);
    const Seismogram record(sim, {99, 299}, 0);
    ASSERT_EQ(sim.run(wave_stage(39 / speed, 0.01 * pulse)).status, dda::RunStatus::completed);
    const std::string set_up = "k h/E = " + to_text(stiffness);
    expect_energy_balance("P15", set_up, sim);
    Case("P15", set_up, "required")
        .contact_frequency_step(sim.contact_frequency_step())
        .expect("speed", "m/s", 200 * column.block_length / (record.arrival(1) - record.arrival(0)), speed,
                relative(.003));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, JointedColumn, testing::Values(.25, 1., 4., 10., 50.),
                         [](const auto& p) { return case_name(case_number(p.param)); });

/// A pulse of 20 blocks at the end of a bar.
struct Reflection {
    double velocity = 0;  ///< at the end face, over that of the pulse
    double stress = 0;    ///< in the last block, over that of the pulse
    double contact_frequency_step = 0;

    explicit Reflection(bool fixed) {
        constexpr int count = 100;
        Bar bar(count, 0.1, dda::Plane::stress);
        if (fixed) bar.s.box({10, -.5}, 1, 1, dda::Motion::fixed);
        bar.push({1e6, 0}, raised_cosine(1e-3));
        Simulation sim(bar.s);
        double largest_stress = 0;
        sim.on_step = [&](const dda::State& state, const dda::StepReport&) {
            const Vec6& v = state.blocks.velocity[count - 1];
            velocity = std::max(velocity, v[0] + v[3] * bar.block_length / 2);
            largest_stress = std::max(largest_stress, -state.blocks.stress[count - 1][0]);
        };
        EXPECT_EQ(sim.run(wave_stage(7e-3, 2e-5)).status, dda::RunStatus::completed);
        velocity /= 1e6 / (bar.density() * 2000);
        stress = largest_stress / 1e6;
        contact_frequency_step = sim.contact_frequency_step();
        expect_energy_balance("V31", fixed ? "fixed end" : "free end", sim);
    }
};

// V31. At a free end the velocity doubles, at a fixed end the stress. The stress of the last block is that
// half a block from the end, cos(2 pi/40) = 0.988 of the value at the end. Dispersion has reduced the pulse
// by 1 %.
TEST(WaveReflection, DoublesTheVelocityAtAFreeEnd) {
    const Reflection r(false);
    Case("V31", "free end", "required")
        .contact_frequency_step(r.contact_frequency_step)
        .expect("velocity over the incident", "1", r.velocity, 2, relative(0.05));
}
TEST(WaveReflection, DoublesTheStressAtAFixedEnd) {
    const Reflection r(true);
    Case("V31", "fixed end", "required; half a block from the end cos(2 pi/40) of it is left")
        .contact_frequency_step(r.contact_frequency_step)
        .expect("stress over the incident", "1", r.stress, 2, relative(0.05));
}

// V34. A bar of 20 m fixed at one end vibrates in its first mode: f = c / 4 L = 25 Hz. The wavelength is 160
// blocks, so the errors are the compliance of the joints, 0.05 %, and that of the integration, (omega
// dt)^2/12.
TEST(FixedFreeBar, VibratesAtItsFirstFrequency) {
    constexpr int count = 40;
    Bar bar(count, 0.5, dda::Plane::stress);
    bar.s.box({-1, -1}, 1, 2, dda::Motion::fixed);
    Simulation sim(bar.s);
    const double k = std::numbers::pi / 40;
    for (int b = 0; b < count; ++b) {
        const double x = (b + .5) * bar.block_length;
        sim.velocity(b)[0] = 0.1 * std::sin(k * x);
        sim.velocity(b)[3] = 0.1 * k * std::cos(k * x);
    }
    sim.restart_ledger();
    std::vector<double> crossings;
    double before = 0;
    Curve engine{"engine", {}, {}};
    sim.on_step = [&](const dda::State& state, const dda::StepReport& report) {
        const double now = state.blocks.velocity[count - 1][0];
        engine.x.push_back(1e3 * state.stage_time);
        engine.y.push_back(now);
        if (before * now < 0) crossings.push_back(state.stage_time - report.step * now / (now - before));
        before = now;
    };
    ASSERT_EQ(sim.run(wave_stage(0.13, 2e-4)).status, dda::RunStatus::completed);
    ASSERT_GE(crossings.size(), 6u);
    const double frequency = 2 / (crossings[5] - crossings[1]);
    Case("V34", "20 m of 0.5 m blocks", "the joints' give and the step's (omega dt)^2/12")
        .contact_frequency_step(sim.contact_frequency_step())
        .expect("f1", "Hz", frequency, 25, relative(2e-3));
    expect_energy_balance("V34", "20 m of 0.5 m blocks", sim);
    Curve mode{"first mode of 25 Hz", engine.x, {}};
    for (const double t : mode.x)
        mode.y.push_back(.1 * std::sin(k * (count - .5) * bar.block_length) *
                         std::cos(2 * std::numbers::pi * 25e-3 * t));
    record_picture("V34", "velocity", "V34: velocity of the free end's block", "time, ms", "velocity, m/s",
                   {mode, engine});
}

}  // namespace
}  // namespace rockslope::waves_test
