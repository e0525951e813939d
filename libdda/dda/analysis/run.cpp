#include "dda/analysis/run.hpp"

#include <algorithm>

#include "dda/analysis/excavate.hpp"
#include "dda/analysis/moving_block.hpp"
#include "dda/analysis/perturb.hpp"
#include "dda/analysis/run_stage.hpp"
#include "dda/analysis/strength_reduction.hpp"

namespace rockslope::dda {

namespace {

/// Applies the resets and the removal that a static stage asks for at its end. They are applied when the next
/// stage begins, so that the last state of a run still has the blocks and displacements of its last stage.
/// @return whether blocks were removed.
bool apply_end_of(const Model& model, const Stage& stage, State& state) {
    if (!stage.is_static()) return false;
    if (stage.reset_displacements) {
        state.displacement_origin = state.blocks.points;
        state.vertex_origin = state.blocks.vertices;
        for (const BlockIndex b : state.centroid_origin.indices()) {
            state.centroid_origin[b] = state.blocks.moments[b].centroid;
        }
        for (Contact& contact : state.contacts.contacts) contact.slip = 0;
    }
    if (stage.reset_joint_history) {
        for (Contact& contact : state.contacts.contacts) {
            contact.history = fresh_history(model.joint_material_at(contact.joint_material).law, true);
        }
    }
    return stage.remove_moving && remove_blocks(model, moving_blocks(model, state, stage.tolerance), state);
}

/// Gives the blocks their initial velocities where the first dynamic stage begins. Until then they are at
/// rest. What that changes of the kinetic energy is external work.
void set_in_motion(const Model& model, std::span<const Stage> stages, std::size_t stage, State& state) {
    if (model.initial_velocity.empty()) return;
    const auto earlier = stages.first(stage);
    if (std::any_of(earlier.begin(), earlier.end(), [](const Stage& each) { return !each.is_static(); }))
        return;
    for (const BlockIndex b : model.blocks())
        state.blocks.velocity[b] = stages[stage].is_static() || !state.is_present(b)
                                       ? Vec6(Vec6::Zero())
                                       : model.initial_velocity[b];
    const RowMap rows(model.motion);
    const ThreadPool one_thread;
    const double before = state.energy.stores();
    Ledger(model, rows, one_thread).update_stored_energy(state, state.energy);
    state.energy.external_work += state.energy.stores() - before;
}

std::vector<BlockIndex> lost_blocks(const State& state) {
    std::vector<BlockIndex> blocks;
    for (const LostBlock& lost : state.lost_blocks) blocks.push_back(lost.block);
    return blocks;
}

/// The model without removed blocks, and its time stepper.
struct ActiveModel {
    ActiveModel(const Model& full_model, const State& state, int threads)
        : reduced_model(state.removed.empty()
                            ? std::nullopt
                            : std::optional(without_removed_blocks(full_model, state.removed))),
          model(reduced_model ? *reduced_model : full_model),
          stepper(model, threads) {}
    ActiveModel(const ActiveModel&) = delete;
    ActiveModel& operator=(const ActiveModel&) = delete;

    std::optional<Model> reduced_model;
    const Model& model;
    TimeStepper stepper;
};

}  // namespace

State initial_state(const Model& model) {
    State state;
    state.blocks = initial_block_system(model);
    state.displacement_origin = state.blocks.points;
    state.vertex_origin = state.blocks.vertices;
    for (const AreaMoments& moments : state.blocks.moments) state.centroid_origin.push_back(moments.centroid);
    for (const BoltSpec& bolt : model.bolts) state.bolt_force.push_back(bolt.pretension);
    state.boundary_reactions = no_reactions(model);
    state.free_fields = fields_at_rest(model);
    const RowMap rows(model.motion);
    const ThreadPool one_thread;
    Ledger(model, rows, one_thread).update_stored_energy(state, state.energy);
    state.energy.initial_stores = state.energy.stores();
    return state;
}

RunOutcome run(const Model& model, std::span<const Stage> stages, State& state, RunObserver& observer,
               const RunOptions& options) {
    std::optional<ActiveModel> active;
    bool resumed = options.resumed;
    const std::size_t end =
        options.last_stage ? static_cast<std::size_t>(*options.last_stage) + 1 : stages.size();
    for (std::size_t k = static_cast<std::size_t>(options.first_stage); k < end; ++k) {
        if (!resumed) {
            if (k > 0 && apply_end_of(model, stages[k - 1], state)) active.reset();
            begin_stage(state);
            set_in_motion(model, stages, k, state);
            if (excavate(model, static_cast<int>(k) + 1, state)) active.reset();
            perturb(model, stages[k], state);
        }
        resumed = false;
        if (model.removes_lost_blocks && remove_blocks(model, lost_blocks(state), state)) active.reset();
        if (!active) active.emplace(model, state, options.threads);
        observer.stage_begins(model, state, stages[k], static_cast<int>(k));
        RunOutcome outcome =
            stages[k].strength_reduction
                ? find_factor_of_safety(active->model, stages[k], state, observer, options.threads)
                : run_stage(active->model, stages[k], active->stepper, state, observer);
        while (outcome.status == RunStatus::blocks_lost) {
            remove_blocks(model, lost_blocks(state), state);
            active.emplace(model, state, options.threads);
            outcome = run_stage(active->model, stages[k], active->stepper, state, observer);
        }
        if (outcome.status != RunStatus::completed && outcome.status != RunStatus::stopped)
            observer.stage_fails(model, state, stages[k], static_cast<int>(k));
        if (outcome.status != RunStatus::completed) return outcome;
        observer.stage_ends(model, state, stages[k], static_cast<int>(k));
    }
    return {};
}

}  // namespace rockslope::dda
