#pragma once

#include <string>

#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::verification {

/// What every dynamic case owes: its energy balance closes, friction never does work on the blocks, and what
/// the time integration takes is told. Asserts and records it.
inline void expect_energy_balance(const std::string& id, const std::string& set_up,
                                  const scene::EnergyMonitor& energy, double frequency_step) {
    Case balance(id, set_up, "energy: required of every dynamic case");
    balance.contact_frequency_step(frequency_step);
    balance.expect_below(energy_residual, "", energy.residual(), 1e-3);
    // Rounding of the sum that the losses are kept in.
    balance.expect_above(friction_work, "", energy.least_friction(), -1e-12);
    balance.inform(integration_loss, "", energy.integration_loss());
}
/// The same for the last dynamic stages of a simulation.
inline void expect_energy_balance(const std::string& id, const std::string& set_up,
                                  const scene::Simulation& sim) {
    ASSERT_TRUE(sim.energy) << "no dynamic stage has been run";
    expect_energy_balance(id, set_up, *sim.energy, sim.contact_frequency_step());
}

}  // namespace rockslope::verification
