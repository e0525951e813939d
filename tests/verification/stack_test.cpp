// Stacks of bricks: the farthest overhang, and the acceleration that overturns or shifts them.

#include <gtest/gtest.h>

#include "support/energy_balance.hpp"
#include "support/record.hpp"
#include "support/scene.hpp"
#include "support/threshold.hpp"

namespace rockslope::stack_test {
namespace {

using namespace scene;
using namespace verification;

/// Rock and springs a hundred times stiffer than the catalogue's, because the bricks of a limit state are
/// rigid.
Scene rigid_bricks(double phi) {
    Scene s;
    s.friction(phi);
    s.model.block_materials[0].youngs_modulus = 1e12;
    s.model.normal_penalty = s.model.shear_penalty = 1e12;
    return s;
}

/// Whether no block moves by more than a millimetre. Bricks that stand move by less than a micrometre.
bool stood(const Simulation& sim) {
    for (int b = 1; b < sim.model.block_count(); ++b)
        if (sim.moved(b).norm() > 1e-3) return false;
    return true;
}

// P04. The centroid of the upper k bricks is over the end of the next one below: each brick of length 1 m
// overhangs that by 1/2k. Bricks that reach farther by a thousandth tip by 4 cm in 1.5 s.
TEST(Overhang, ReachesTheHarmonicSum) {
    for (const int count : {4, 8}) {
        double expected = 0;
        for (int k = 1; k <= count; ++k) expected += 1 / (2. * k);
        EXPECT_NEAR(expected, count == 4 ? 1.041667 : 1.358929, 1e-6);
        double frequency_step = 0;
        std::optional<EnergyMonitor> energy;  // of the last run that fell
        const auto stands = [&](double share) {
            Scene s = rigid_bricks(30);
            s.box({-3, -1}, 3, 1, dda::Motion::fixed);
            double reach = 0;
            for (int k = count; k >= 1; --k) {
                reach += share / (2. * k);
                s.box({reach - 1, .25 * (count - k)}, 1, .25);
            }
            Simulation sim(s);
            EXPECT_EQ(sim.shake(1.5, 1e-3).status, dda::RunStatus::completed);
            if (!stood(sim)) {
                frequency_step = sim.contact_frequency_step();
                energy = sim.energy;
            }
            return stood(sim);
        };
        const std::string set_up = to_text(count) + " bricks";
        Case overhang("P04", set_up, "required; found by halving to 0.1 %");
        overhang.expect_outcome("0.99 of the sum", stands(.99) ? "stands" : "falls", "stands");
        overhang.expect_outcome("1.01 of the sum", stands(1.01) ? "stands" : "falls", "falls");
        const double found = threshold(1.01, .99, 4, stands);
        overhang.expect("farthest reach over the length of a brick", "", found * expected, expected,
                        relative(.01));
        expect_energy_balance("P04", set_up, *energy, frequency_step);
    }
}

// P13. A stack of five, 2 m high. One of 1 m width overturns at k = b/h, one of 4 m width slides at k =
// tan(phi) on its base and nowhere else before. The acceleration grows within a second and stays for two;
// at 1.001 of the limit the stack then has moved by a centimetre or more.
TEST(PushedStack, OverturnsOrSlidesAtAHalf) {
    for (const bool overturns : {true, false}) {
        double frequency_step = 0;
        std::optional<EnergyMonitor> energy;  // of the last run that failed
        const auto stands = [&](double k) {
            Scene s = rigid_bricks(overturns ? 60 : std::atan(.5) * 180 / std::numbers::pi);
            s.box({-10, -1}, 20, 1, dda::Motion::fixed);
            for (int i = 0; i < 5; ++i) s.box({0, .4 * i}, overturns ? 1 : 4, .4);
            Simulation settled(s);
            EXPECT_EQ(settled.settle().status, dda::RunStatus::completed);
            s.model.loads.push_back(
                dda::BodyLoad{dda::BlockIndex::none(), {k * g, 0}, dda::TimeTable({0, 1, 100}, {0, 1, 1})});
            Simulation sim(s);
            sim.state = settled.state;
            sim.restart_ledger();
            EXPECT_EQ(sim.shake(3, 1e-3).status, dda::RunStatus::completed);
            if (!stood(sim)) {
                frequency_step = sim.contact_frequency_step();
                energy = sim.energy;
            }
            return stood(sim);
        };
        const std::string set_up =
            overturns ? "five of 1 m x 0.4 m, φ = 60°" : "five of 4 m x 0.4 m, μ = 0.5";
        ASSERT_FALSE(stands(.505));
        ASSERT_TRUE(stands(.495));
        const double found = threshold(.505, .495, 5, stands);
        Case pushed("P13", set_up, "required; found by halving to 0.06 %");
        pushed.contact_frequency_step(frequency_step);
        pushed.expect(overturns ? "k that overturns it" : "k that shifts it", "", found, .5, relative(.002));
        expect_energy_balance("P13", set_up, *energy, frequency_step);
    }
}

}  // namespace
}  // namespace rockslope::stack_test
