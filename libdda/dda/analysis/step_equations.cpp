#include "dda/analysis/step_equations.hpp"

#include <algorithm>
#include <utility>

#include "dda/analysis/energy_watch.hpp"
#include "dda/analysis/shear_sharing.hpp"
#include "dda/contact/find_contacts.hpp"

namespace rockslope::dda {

namespace {

/// Distance added to every search radius, over the median edge length.
constexpr double radius_rounding = 1e-4;

/// Friction that gives energy in a step by more than this fraction of what was turned over so far has its
/// dilation limited.
constexpr double tolerated_gain = 1e-7;

/// The time at which load histories are evaluated, s: the end of the step.
double load_time(const Stage& stage, const State& state, double dt) {
    return state.dynamic_time + stage.time_of_step(dt).duration();
}

void assemble_base(const StepSetting& setting, const Stage& stage, const State& state, StepEquations& step) {
    const Model& model = setting.model;
    const RowMap& rows = setting.rows;
    step.base.stiffness.assign(rows.count(), Mat6::Zero());
    step.base.load.assign(rows.count(), Vec6::Zero());
    add_inertia(rows, state.blocks, step.newmark, stage.mass_damping, step.base);
    add_elasticity(model, rows, state.blocks, step.dt, step.base);
    add_loads(model, rows, state.blocks, step.mid, step.loads, step.base);
    add_fixed_points(model, rows, state.blocks, step.mid, step.base);
    add_boundaries(step.boundaries, rows, state.blocks, step.newmark, step.base);
}

}  // namespace

Prediction initial_prediction(const StepSetting& setting, const Stage& stage, const State& state, double dt) {
    const Model& model = setting.model;
    PerBlock<Vec6> free_motion(state.blocks.velocity);
    for (Vec6& displacement : free_motion) displacement *= dt;
    // A static step is longer than the control's where its displacements stay as small, Eq. (41).
    const double fall = std::min(dt, stage.control.step);
    Prediction prediction;
    prediction.search_radius = initial_search_radius(
        state.contacts.contacts,
        {.motion = largest_displacement(state.blocks, model.topology, free_motion, setting.pool),
         .change = 2 * model.gravity.norm() * fall * fall,
         .limit = setting.scale.displacement_limit(stage.control),
         .rounding = radius_rounding * setting.scale.edge_length});
    prediction.predicted =
        prescribe_motion(model, stage, state.blocks, dt, state.stage_time + dt).displacement;
    for (const BlockIndex b : setting.rows.block_of) prediction.predicted[b] = free_motion[b];
    return prediction;
}

StepEquations step_equations(const StepSetting& setting, const Stage& stage, const State& state, double dt,
                             const Prediction& prediction, RowContacts& row_contacts) {
    const auto& [model, rows, scale, pool, times] = setting;
    StepEquations step;
    step.dt = dt;
    step.newmark = {stage.newmark_beta, stage.newmark_gamma, dt};
    step.prescribed = prescribe_motion(model, stage, state.blocks, dt, state.stage_time + dt);
    step.mid = predict_mid_step(model, state.blocks, prediction.predicted, pool);
    end_of(Phase::preparation, times);
    FoundContacts found =
        find_contacts(model, state.contacts,
                      {state.blocks.vertices, step.mid.vertices, prediction.forced, prediction.search_radius,
                       scale.edge_length, undetected_depth * scale.edge_length + scale.coordinate_rounding,
                       stage.time_of_step(dt).duration(), state.step_count == 0},
                      pool, times);
    step.contacts = std::move(found.set);
    step.segments = std::move(found.segments);
    share_shear_force(model, step.segments, step.contacts.contacts);
    step.springs =
        contact_springs(model, rows, step.mid, step.prescribed.displacement, step.contacts.contacts, pool);
    row_contacts.find(rows.count(), step.springs);
    if (!stage.is_static())
        step.dashpots = contact_dashpots(model, {rows, state.blocks, step.mid}, step.newmark,
                                         {step.contacts.contacts, step.springs, row_contacts}, pool);
    step.bolts = bolt_springs(model, rows, step.mid, step.prescribed.displacement);
    const StageInstant end{.stage = stage, .time = state.stage_time + dt};
    step.fields = advance_fields(model, end, state.blocks, state.free_fields, step.newmark);
    step.boundaries = boundary_terms(model, rows, step.mid, end, state.boundary_reactions, step.fields);
    step.loads = {load_time(stage, state, dt), frame_acceleration_over_step(stage, dt, end.time)};
    assemble_base(setting, stage, state, step);
    end_of(Phase::preparation, times);
    return step;
}

StepProblem step_problem(const StepSetting& setting, const Stage& stage, const State& state,
                         const StepEquations& step, const RowContacts& row_contacts) {
    const double stiffness = std::max(max_spring_stiffness(step.springs), setting.model.normal_penalty);
    return {.model = setting.model,
            .control = stage.control,
            .rows = setting.rows,
            .base = step.base,
            .blocks = state.blocks,
            .prescribed = step.prescribed.displacement,
            .contacts = step.contacts.contacts,
            .segments = step.segments,
            .guess = {},
            .springs = step.springs,
            .row_contacts = row_contacts,
            .bolts = step.bolts,
            .bolt_force = state.bolt_force,
            .time = stage.time_of_step(step.dt),
            .rounding_force = setting.scale.coordinate_rounding * stiffness,
            .dashpots = step.dashpots,
            .tolerated_gain = tolerated_gain * turned_over(state.energy)};
}

}  // namespace rockslope::dda
