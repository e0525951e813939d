#include "dda/analysis/excavate.hpp"

#include <algorithm>

#include "dda/analysis/ledger.hpp"

namespace rockslope::dda {

namespace {

bool is_attached(const Model& model, PointIndex point, const PerBlock<std::uint8_t>& removed) {
    const BlockIndex block = model.material_points[point].block;
    return removed.empty() || removed[block] == 0;
}

bool is_attached(const Model& model, const BoltSpec& bolt, const PerBlock<std::uint8_t>& removed) {
    return is_attached(model, bolt.first, removed) && is_attached(model, bolt.second, removed);
}

/// The forces of the remaining bolts. `removed` includes the blocks of `state.removed`.
std::vector<double> remaining_bolt_forces(const Model& model, const State& state,
                                          const PerBlock<std::uint8_t>& removed) {
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

Model without_removed_blocks(const Model& model, const PerBlock<std::uint8_t>& removed) {
    Model active_model = model;
    for (const BlockIndex b : removed.indices()) {
        if (removed[b] != 0) active_model.motion[b] = Motion::removed;
    }
    std::erase_if(active_model.bolts,
                  [&](const BoltSpec& bolt) { return !is_attached(model, bolt, removed); });
    std::erase_if(active_model.fixed_points,
                  [&](const FixedPoint& fixed) { return !is_attached(model, fixed.point, removed); });
    return active_model;
}

bool remove_blocks(const Model& model, std::span<const BlockIndex> blocks, State& state) {
    PerBlock<std::uint8_t> removed = state.removed;
    removed.resize(model.block_count(), 0);
    bool any = false;
    for (const BlockIndex block : blocks) {
        std::uint8_t& is_removed = removed[block];
        any = any || is_removed == 0;
        is_removed = 1;
    }
    if (!any) return false;

    state.bolt_force = remaining_bolt_forces(model, state, removed);
    state.removed = std::move(removed);
    std::erase_if(state.contacts.contacts, [&](const Contact& contact) {
        return !state.is_present(contact.corner_block) || !state.is_present(contact.edge_block);
    });
    state.contacts.candidates.clear();
    state.contacts.reference.clear();
    for (const BlockIndex b : state.removed.indices()) {
        if (state.removed[b] == 0) continue;
        state.blocks.velocity[b].setZero();
        state.blocks.acceleration[b].setZero();
        state.blocks.stress[b].setZero();
    }
    const Model active_model = without_removed_blocks(model, state.removed);
    const RowMap rows(active_model.motion);
    const double before = state.energy.stores();
    const ThreadPool one_thread;
    Ledger(active_model, rows, one_thread).update_stored_energy(state, state.energy);
    state.energy.excavated += before - state.energy.stores();
    return true;
}

bool excavate(const Model& model, int stage, State& state) {
    std::vector<BlockIndex> blocks;
    for (const Excavation& excavation : model.excavations)
        if (excavation.stage <= stage)
            blocks.insert(blocks.end(), excavation.blocks.begin(), excavation.blocks.end());
    return remove_blocks(model, blocks, state);
}

}  // namespace rockslope::dda
