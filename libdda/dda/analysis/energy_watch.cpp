#include "dda/analysis/energy_watch.hpp"

#include <algorithm>
#include <cstdio>

namespace rockslope::dda {

double turned_over(const Energy& energy) {
    const double lost = energy.friction_loss + energy.friction_returned + energy.damping_loss +
                        energy.contact_damping_loss + std::max(energy.numerical_loss, 0.0) +
                        std::max(energy.released, 0.0) + energy.boundary_loss;
    return std::max(energy.kinetic + lost, energy.strain + energy.contact + energy.constraint);
}

bool returns_friction(const Energy& energy) {
    const double taken = energy.friction_loss + energy.friction_returned;
    return energy.friction_returned > returned_share_told * taken;
}

bool creates_energy(const Energy& energy) {
    return energy.friction_returned > returned_share_allowed * turned_over(energy);
}

std::string describe_returned(const Model& model, const Energy& energy) {
    const EnergyGain& gain = energy.largest_gain;
    char where[200] = "";
    if (gain.amount > 0)
        std::snprintf(
            where, sizeof where,
            "; most in one step, %.3g J/m, at t = %.6g s by block %d on block %d, joint material '%s'",
            gain.amount, gain.time, gain.corner_block.value(), gain.edge_block.value(),
            model.joint_material_at(gain.joint_material).name.c_str());
    char text[400];
    std::snprintf(text, sizeof text, "friction returned %.3g J/m of %.3g J/m turned over, which it cannot%s",
                  energy.friction_returned, turned_over(energy), where);
    return text;
}

}  // namespace rockslope::dda
