// Blocks that meet.

#include <gtest/gtest.h>

#include "support/record.hpp"
#include "support/scene.hpp"

namespace {

using namespace scene;
using namespace verification;

// V29. Two equal frictionless blocks head on: contact forces come in equal and opposite pairs, so momentum is
// conserved to rounding whatever the integration does to the energy. The bound is relative to the momentum of
// one block.
TEST(Collision, ConservesMomentum) {
    Scene s;
    s.model.gravity.setZero();
    const int left = s.box({0, 0}, 1, 1);
    const int right = s.box({1.01, 0}, 1, 1);
    Simulation sim(s);
    sim.velocity(left)[0] = 1;
    sim.velocity(right)[0] = -1;
    sim.restart_ledger();
    const auto momentum = [&] {
        return 2500 * (sim.velocity(left).head<2>() + sim.velocity(right).head<2>());
    };
    ASSERT_EQ(sim.shake(0.05, 1e-4).status, dda::RunStatus::completed);
    EXPECT_LT(sim.velocity(left)[0], 0) << "they have met and parted";
    const std::string set_up = "two squares at ±1 m/s";
    Case("V29", set_up, "contact forces come in pairs: rounding is left")
        .contact_frequency_step(sim.contact_frequency_step())
        .expect_below("momentum over that of one block", "", momentum().norm() / 2500, 1e-8);
    Case("V29", set_up,
         "the impact strains the blocks by v/c = 5e-4, and the ledger's strain energy is that of small "
         "strains")
        .contact_frequency_step(sim.contact_frequency_step())
        .expect_below("energy residual over kinetic energy", "", sim.state.energy.residual() / 2500, 5e-4);
}

}  // namespace
