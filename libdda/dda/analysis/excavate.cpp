#include "dda/analysis/excavate.hpp"

#include <algorithm>

#include "dda/analysis/ledger.hpp"

namespace rockslope::dda {

namespace {

bool is_attached(const Model& model, int point, const std::vector<std::uint8_t>& removed) {
    const int block = model.material_points[static_cast<std::size_t>(point)].block;
    return removed.empty() || removed[static_cast<std::size_t>(block)] == 0;
}

bool is_attached(const Model& model, const BoltSpec& bolt, const std::vector<std::uint8_t>& removed) {
    return is_attached(model, bolt.first, removed) && is_attached(model, bolt.second, removed);
}

/// The forces of the bolts that stay; both lists of blocks, the earlier in the later.
std::vector<double> kept_bolt_forces(const Model& model, const State& state,
                                     const std::vector<std::uint8_t>& removed) {
    std::vector<double> forces;
    std::size_t k = 0;
    for (const BoltSpec& bolt : model.bolts) {
        if (!is_attached(model, bolt, state.removed)) continue;
        if (is_attached(model, bolt, removed)) forces.push_back(state.bolt_force[k]);
        ++k;
    }
    return forces;
}

}  // namespace

Model without_removed_blocks(const Model& model, const std::vector<std::uint8_t>& removed) {
    Model rest = model;
    for (std::size_t b = 0; b < removed.size(); ++b) {
        if (removed[b] != 0) rest.motion[b] = Motion::removed;
    }
    std::erase_if(rest.bolts, [&](const BoltSpec& bolt) { return !is_attached(model, bolt, removed); });
    std::erase_if(rest.fixed_points,
                  [&](const FixedPoint& fixed) { return !is_attached(model, fixed.point, removed); });
    return rest;
}

bool excavate(const Model& model, int stage, State& state) {
    std::vector<std::uint8_t> removed = state.removed;
    removed.resize(static_cast<std::size_t>(model.block_count()), 0);
    bool any = false;
    for (const Excavation& excavation : model.excavations) {
        if (excavation.stage > stage) continue;
        for (const int block : excavation.blocks) {
            std::uint8_t& is_removed = removed[static_cast<std::size_t>(block)];
            any = any || is_removed == 0;
            is_removed = 1;
        }
    }
    if (!any) return false;

    state.bolt_force = kept_bolt_forces(model, state, removed);
    state.removed = std::move(removed);
    std::erase_if(state.contacts.contacts, [&](const Contact& contact) {
        return !state.is_present(contact.corner_block) || !state.is_present(contact.edge_block);
    });
    state.contacts.candidates.clear();
    state.contacts.reference.clear();
    for (std::size_t b = 0; b < state.removed.size(); ++b) {
        if (state.removed[b] == 0) continue;
        state.blocks.velocity[b].setZero();
        state.blocks.acceleration[b].setZero();
        state.blocks.stress[b].setZero();
    }
    const Model rest = without_removed_blocks(model, state.removed);
    const RowMap rows(rest.motion);
    const double before = state.energy.stores();
    Ledger(rest, rows).update_stored_energy(state, state.energy);
    state.energy.excavated += before - state.energy.stores();
    return true;
}

}  // namespace rockslope::dda
