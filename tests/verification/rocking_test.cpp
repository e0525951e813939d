// Slender blocks that rock on a corner: uplift, free rocking, overturning.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/rocking_block.hpp"
#include "support/scene.hpp"

namespace rockslope::rocking_test {
namespace {

using namespace scene;
using namespace verification;

constexpr double pi = std::numbers::pi;

// V24. The force at the heel is W/2 - m a h/(2 b), zero at a = g b/h. The base acceleration rises in one
// second and is constant for another. At 0.99 of that acceleration the heel still carries a hundredth of its
// force at rest, a penetration of 2.45e-9 m.
TEST(Uplift, BeginsAtTheSlendernessTimesGravity) {
    for (const double share : {.99, 1.01}) {
        Scene s;
        s.friction(45);
        s.box({-5, -1}, 10, 1, dda::Motion::prescribed, 0, "base");
        const int block = s.box({0, 0}, .5, 2);
        Simulation sim(s);
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        sim.restart_ledger();
        dda::Stage stage;
        stage.name = "pull";
        stage.duration = 2;
        stage.control.step = 4e-5;
        const double a = share * .25 * g;
        stage.base_motions.push_back({"base", dda::TimeTable({0, 1, 3}, {0, a, a}), {}});
        ASSERT_EQ(sim.run(stage).status, dda::RunStatus::completed);
        const dda::CornerIndex corner = s.model.topology.block_corners[block];
        const double heel = sim.state.blocks.vertices[corner + 1].y();
        const std::string set_up = "0.5 m x 2 m, a = " + to_text(share) + " g B/H";
        expect_energy_balance("V24", set_up, sim);
        Case uplift(
            "V24", set_up,
            "at rest the heel is 2.5e-7 m deep, a hundredth of that at 0.99; above, it rises as exp(p t)");
        uplift.contact_frequency_step(sim.contact_frequency_step());
        uplift.expect_outcome("heel", heel > 0 ? "lifts" : "presses", share < 1 ? "presses" : "lifts");
        if (share < 1)
            uplift.expect("height of the heel", "m", heel, -2.4525e-9, relative(.02));
        else
            uplift.expect_above("height of the heel", "m", heel, 1e-3);
    }
}

struct RockingCase {
    const char* id;
    double width, height, angle, first_impact, speed;
    std::vector<double> later;  ///< s, further impacts of Housner's block
    friend std::ostream& operator<<(std::ostream& out, const RockingCase& c) {
        return out << c.width << "x" << c.height;
    }
};
class FreeRocking : public testing::TestWithParam<RockingCase> {};

// V22, V23. The fall up to the first impact follows Housner's equation. The loss of an impact is the engine's
// own. It is close to Housner's, because both corners touch when the base is flat and angular momentum is
// conserved.
TEST_P(FreeRocking, FallsAsHousnersBlock) {
    const RockingCase& c = GetParam();
    const HousnerBlock housner(c.width, c.height);
    const HousnerBlock::Motion reference = housner.release(
        c.angle, [](double) { return 0.; }, 3);
    EXPECT_NEAR(reference.impacts.at(0), c.first_impact, 1e-4);
    EXPECT_NEAR(reference.impact_speed.at(0), c.speed, 2e-4);
    RockingBlock block;
    block.width = c.width;
    block.height = c.height;
    block.run(c.angle, {}, 3);
    ASSERT_GE(block.impacts.size(), 2u);
    const std::string set_up =
        to_text(c.width) + " m x " + to_text(c.height) + " m, θ₀ = " + to_text(c.angle);
    Case rocking(c.id, set_up, "required of the first fall; later impacts depend on the restitution");
    rocking.contact_frequency_step(block.frequency_step);
    rocking.expect("first impact", "s", block.impacts[0], c.first_impact, relative(.01));
    rocking.expect("speed at it", "rad/s", block.impact_speed[0], c.speed, relative(.01));
    rocking.inform("speed at the second impact over that at the first", "",
                   block.impact_speed[1] / block.impact_speed[0], housner.restitution());
    for (std::size_t k = 0; k < c.later.size() && k + 1 < block.impacts.size(); ++k)
        rocking.inform("impact " + std::to_string(k + 2), "s", block.impacts[k + 1], c.later[k]);
    expect_energy_balance(c.id, set_up, *block.energy, block.frequency_step);
    record_picture(c.id, to_text(c.width) + "x" + to_text(c.height), std::string(c.id) + ": " + set_up,
                   "time, s", "angle, rad",
                   {{"Housner, e = 1 - 3/2 sin²α", reference.time, reference.angle},
                    {"engine", block.time, block.angle}});
}

INSTANTIATE_TEST_SUITE_P(
    Catalogue, FreeRocking,
    testing::Values(RockingCase{"V22", .5, 2, .1, .4185, .5258, {1.1240, 1.7334, 2.2676}},
                    RockingCase{"V23", .4, 1.2, .15, .3649, .9228, {}},
                    RockingCase{"V23", 1, 4, .12, .6860, .3968, {}}));

struct PulseCase {
    double width, height, frequency, amplitude;  ///< m, m, Hz, g
    friend std::ostream& operator<<(std::ostream& out, const PulseCase& c) {
        return out << c.width << "x" << c.height << "_" << c.frequency << "Hz";
    }
};
class LongOverturning : public testing::TestWithParam<PulseCase> {};

bool engine_overturns(const PulseCase& c, double amplitude, RockingBlock& block) {
    std::vector<double> times;
    std::vector<double> values;
    for (int k = 0; k <= 1000; ++k) {
        times.push_back(k / (1000 * c.frequency));
        values.push_back(amplitude * g * std::sin(2 * pi * k / 1000));
    }
    block = RockingBlock();
    block.width = c.width;
    block.height = c.height;
    block.run(0, dda::TimeTable(times, values), 1 / c.frequency + 3);
    return block.largest_angle() > 1;
}

/// Draws the rotation under a pulse that does not overturn the block, with that of Housner's block.
void draw_pulse(const PulseCase& c, double amplitude, const RockingBlock& block) {
    if (c.frequency != 1) return;
    const HousnerBlock::Motion reference =
        HousnerBlock(c.width, c.height)
            .release(
                0,
                [&](double t) {
                    return t * c.frequency > 1 ? 0 : amplitude * g * std::sin(2 * pi * c.frequency * t);
                },
                1 / c.frequency + 3);
    const std::string size = to_text(c.width) + " m x " + to_text(c.height) + " m";
    record_picture("V25", to_text(c.width) + "x" + to_text(c.height),
                   "V25: " + size + ", one sine of 1 Hz and " + to_text(amplitude) + " g", "time, s",
                   "angle, rad",
                   {{"Housner, e = 1 - 3/2 sin²α", reference.time, reference.angle},
                    {"engine", block.time, block.angle}});
}

// V25. Amplitudes are increased in steps of 2 % from 0.94 of the expected one until the block overturns.
// Overturning is not monotonic in the amplitude; the lowest one counts. A block near overturning needs about
// 10/p, and the runs end 3 s after the pulse.
TEST_P(LongOverturning, TakesTheAmplitudeOfHousnersBlock) {
    const PulseCase& c = GetParam();
    RockingBlock block;
    double first = .94;
    engine_overturns(c, first * c.amplitude, block);
    draw_pulse(c, first * c.amplitude, block);
    while (first < 1.1 && !engine_overturns(c, first * c.amplitude, block)) first += .02;
    const std::string set_up =
        to_text(c.width) + " m x " + to_text(c.height) + " m, " + to_text(c.frequency) + " Hz";
    Case overturning("V25", set_up,
                     "required; the edge is resolved to 2 %, and the restitution is the engine's");
    overturning.contact_frequency_step(block.frequency_step);
    overturning.expect("first overturning amplitude", "g", first * c.amplitude, c.amplitude, relative(.05));
    expect_energy_balance("V25", set_up, *block.energy, block.frequency_step);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, LongOverturning,
                         testing::Values(PulseCase{.5, 2, .5, .2861}, PulseCase{.5, 2, 1, .3180},
                                         PulseCase{.5, 2, 2, .6063}, PulseCase{.4, 1.2, .5, .3755},
                                         PulseCase{.4, 1.2, 1, .4036}, PulseCase{.4, 1.2, 2, .5722}));

}  // namespace
}  // namespace rockslope::rocking_test
