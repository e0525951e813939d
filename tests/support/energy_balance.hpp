#pragma once

#include <string>

#include "support/record.hpp"
#include "support/scene.hpp"

namespace rockslope::verification {

/// Asserts and records the energy balance of a dynamic case: its residual is small, friction never does work
/// on the blocks, and the loss by the time integration is reported.
inline void expect_energy_balance(const std::string& id, const std::string& set_up,
                                  const scene::EnergyMonitor& energy, double frequency_step) {
    Case balance(id, set_up, "energy: required of every dynamic case");
    balance.contact_frequency_step(frequency_step);
    balance.expect_below(energy_residual, "", energy.residual(), 1e-3);
    // The tolerance is the rounding of the accumulated losses.
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
