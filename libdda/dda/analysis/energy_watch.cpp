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

namespace {

/// Where and when most of a gain came; empty if nowhere.
std::string place_of(const Model& model, const EnergyGain& gain) {
    if (!(gain.amount > 0)) return {};
    char text[200];
    std::snprintf(text, sizeof text,
                  "; most in one step, %.3g J/m, at t = %.6g s by block %d on block %d, joint material '%s'",
                  gain.amount, gain.time, gain.corner_block.value(), gain.edge_block.value(),
                  model.joint_material_at(gain.joint_material).name.c_str());
    return text;
}

/// "`what` 20 J/m of 100 J/m turned over, `but`".
std::string amount_of(const char* what, double amount, const Energy& energy, const char* but) {
    char text[300];
    std::snprintf(text, sizeof text, "%s %.3g J/m of %.3g J/m turned over, %s", what, amount,
                  turned_over(energy), but);
    return text;
}

}  // namespace

std::string describe_returned(const Model& model, const Energy& energy) {
    return amount_of("friction returned", energy.friction_returned, energy, "which it cannot") +
           place_of(model, energy.largest_gain);
}

std::vector<std::string> energy_from_nowhere(const Model& model, const Energy& energy) {
    std::vector<std::string> lines;
    const double told = returned_share_told * turned_over(energy);
    if (returns_friction(energy)) lines.push_back(describe_returned(model, energy));
    if (-energy.released > told)
        lines.push_back(amount_of("contacts whose springs were replaced gained", -energy.released, energy,
                                  "for their lengths or joints changed") +
                        place_of(model, energy.largest_spring_gain));
    if (-energy.numerical_loss > told)
        lines.push_back(amount_of("the time integration gave", -energy.numerical_loss, energy,
                                  "which gamma = 1 would not"));
    return lines;
}

}  // namespace rockslope::dda
