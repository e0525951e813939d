// Excavation between stages: stresses and motion of the remaining blocks.

#include <gtest/gtest.h>

#include "support/column.hpp"
#include "support/energy_balance.hpp"
#include "support/record.hpp"

namespace rockslope::excavation_test {
namespace {

using namespace scene;
using namespace verification;

// V53. A column of four blocks loses its top block at the start of stage 2 and the next one at the start of
// stage 3. The stress of a constant-strain block carries half its own weight and all blocks above, as in V04.
// No part of the removed load may remain in the springs.
TEST(Excavation, TheColumnCarriesTheRemainingBlocks) {
    Scene s = column(4);
    s.model.excavations = {{"crest", 2, {4}}, {"next", 3, {3}}};
    Simulation sim(s);
    for (const int left : {4, 3, 2}) {
        ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
        Case row("V53", "column of four, " + std::to_string(left) + " left",
                 "settled to the static tolerance; springs and blocks shorten by 1e-6 of their length");
        row.contact_frequency_step(sim.contact_frequency_step());
        for (int k = 1; k <= left; ++k)
            row.expect("σ_y(" + std::to_string(k) + ")", "Pa", sim.stress(k)[1], -2500 * g * (left - k + 0.5),
                       relative(1e-5));
    }
}

// V53. The lower of two settled blocks is removed at the start of a dynamic stage. The upper one falls freely
// from that instant.
TEST(Excavation, ABlockWithoutItsSupportFalls) {
    Scene s = column(2);
    s.model.excavations = {{"support", 2, {1}}};
    Simulation sim(s);
    ASSERT_EQ(sim.settle().status, dda::RunStatus::completed);
    ASSERT_EQ(sim.shake(0.3, 0.001).status, dda::RunStatus::completed);
    Case row(
        "V53", "support taken out, 0.3 s",
        "Newmark (1/2, 1) is exact for a constant acceleration; what the settled state still moves is left");
    row.expect("y(0.3 s)", "m", sim.moved(2).y(), -g * 0.3 * 0.3 / 2, absolute(1e-9));
    row.expect("v(0.3 s)", "m/s", sim.velocity(2)[1], -g * 0.3, absolute(1e-8));
    expect_energy_balance("V53", "support taken out, 0.3 s", sim);
}

}  // namespace
}  // namespace rockslope::excavation_test
