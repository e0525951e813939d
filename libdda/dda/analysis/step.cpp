#include "dda/analysis/step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/analysis/advance_contacts.hpp"
#include "dda/analysis/bonds.hpp"
#include "dda/analysis/energy_watch.hpp"
#include "dda/analysis/rotation_prediction.hpp"
#include "dda/solve/contact_solution.hpp"

namespace rockslope::dda {

namespace {

/// Largest number of attempts at a step. Another one follows when a vertex moves by more than half of the
/// search radius, when one penetrates undetected, or when the predicted rotations were wrong.
constexpr int attempt_limit = 8;
/// Largest number of attempts repeated because of wrong rotations. Each one reduces the rotation error by a
/// factor of about the rotation, rad.
constexpr int rotation_correction_limit = 3;
/// In a step that was cut to less than a thousandth the tolerated depth of an undetected penetration is
/// larger by as much as the step is shorter, up to this value: a depth that such steps do not prevent is none
/// to end a run for.
constexpr double largest_undetected_depth = 1e-6;
constexpr double hopeless_cut = 1e-3;
/// Tolerated penetration of a vertex that enters and leaves a block within a step, over the median edge
/// length. The test replaces arcs by straight paths, and strain moves the vertices of a joint by less than
/// this.
constexpr double clipping_depth = 1e-5;
/// Largest force that coordinate rounding may cause in the stiffest spring, over the mean weight of a block.
/// Forces converge no closer than this rounding, so with stiffer springs any state would pass for
/// equilibrium.
constexpr double rounding_force_limit = 0.1;

/// A step in which friction gives more energy than this fraction of what was turned over so far is cut: a
/// rough block that lands on one end turns the joint's forces round in it. It is accepted where the step is
/// as short as the second value, over that of the control.
constexpr double rejected_gain = 1e-4;
constexpr double shortest_for_gain = 1.0 / 20;

double velocity_factor(const Stage& stage) {
    return stage.is_static() ? 0.0 : stage.dynamic_coefficient;
}

/// Strain changes the moments of inertia of a block. Corrects the angular velocity so that the angular
/// momentum is conserved. @return the kinetic energy lost, J per metre.
double conserve_angular_momentum(double mass, const AreaMoments& before, const Vec6& velocity_before,
                                 const AreaMoments& after, Vec6& velocity) {
    const Mat6 inertia_before = mass_matrix(mass, before);
    const Mat6 inertia = mass_matrix(mass, after);
    const Vec6 momentum_before = inertia_before * velocity_before;
    velocity[2] += (momentum_before[2] - inertia.row(2).dot(velocity)) / inertia(2, 2);
    return (velocity_before.dot(momentum_before) - velocity.dot(inertia * velocity)) / 2;
}

/// Asks for another attempt about the mid-step of the displacements found.
void correct_rotations(const PerBlock<Vec6>& displacement, InitialGuess found, Prediction& prediction) {
    ++prediction.rotation_corrections;
    prediction.turning_block = worst_predicted(prediction.predicted, displacement);
    prediction.retry_from(displacement, std::move(found));
}

}  // namespace

TimeStepper::TimeStepper(const Model& model, int threads)
    : model_(model),
      pool_(threads),
      rows_(model.motion),
      scale_(model, rows_),
      ledger_(model_, rows_, pool_),
      solver_(make_linear_solver(model.solver, pool_)) {}

StepAttempt TimeStepper::advance(const Stage& stage, const State& state, double dt) {
    StepAttempt attempt;
    StepCounts counts;
    if (work_.times != nullptr) work_.times->start();
    Prediction prediction = initial_prediction(setting(), stage, state, dt);
    for (int attempts = 0; attempts < attempt_limit && prediction.needs_retry; ++attempts) {
        attempt = attempt_with(stage, state, dt, prediction);
        counts += attempt.report;
    }
    end_of(Phase::update, work_.times);
    static_cast<StepCounts&>(attempt.report) = counts;
    return attempt;
}

StepAttempt TimeStepper::attempt_with(const Stage& stage, const State& state, double dt,
                                      Prediction& prediction) {
    StepAttempt attempt;
    prediction.needs_retry = false;
    StepEquations step = step_equations(setting(), stage, state, dt, prediction, row_contacts_);
    if (is_too_stiff_for_rounding(step)) {
        attempt.rejection = Rejection::too_stiff;
        return attempt;
    }
    OpenCloseResult result = solve(stage, state, step, prediction);
    static_cast<StepCounts&>(attempt.report) = result;
    if (!result.converged) {
        if (result.gaps_unsettled) correct_mid_step(stage, state, step, result, prediction);
        attempt.rejection = result.singular ? Rejection::singular : Rejection::not_converged;
        if (!result.singular && result.turns_otherwise &&
            prediction.rotation_corrections >= rotation_correction_limit) {
            attempt.rejection = Rejection::turning_otherwise;
            attempt.turning_block = prediction.turning_block;
            attempt.rotation = prediction.predicted[attempt.turning_block][2];
        }
        if (result.worst_contact.exists())
            attempt.worst_contact = step.contacts.contacts[result.worst_contact];
        return attempt;
    }
    const PerBlock<Vec6> displacement =
        rows_.of_all_blocks(step.prescribed.displacement, result.displacement);
    const double moved = largest_displacement(state.blocks, model_.topology, displacement, pool_);
    attempt.report.largest_displacement = moved;
    attempt.rejection = Rejection::excessive_displacement;  // stays so if no prediction fits the motion
    if (!(moved <= scale_.displacement_limit(stage.control))) return attempt;  // also if it is not a number
    if (correct_motion(state, step, result, displacement, moved, prediction)) return attempt;
    attempt.state = updated_state(stage, state, step, result, displacement);
    const double max_stiffness = max_spring_stiffness(step.springs);
    step.springs = {};  // frees memory; the next search needs as much
    const std::vector<UndetectedPenetration> undetected =
        undetected_penetrations(stage, state, attempt.state, prediction.search_radius.largest());
    if (!undetected.empty()) {
        attempt.rejection = Rejection::undetected_penetration;
        attempt.worst_contact =
            deepest_penetration_as_contact(model_, attempt.state.blocks.vertices, undetected);
        // First retry with the displacements found, which may make detection find the contact. A pair that
        // penetrates undetected again becomes a forced candidate.
        if (can_be_prevented(undetected) &&
            (merge_pairs(undetected, prediction.undetected) || merge_pairs(undetected, prediction.forced)))
            prediction.retry_from(displacement, {step.contacts.contacts, std::move(result.contacts)});
        return attempt;
    }
    if (friction_drives(stage, state, attempt.state)) {
        attempt.rejection = Rejection::driving_friction;
        return attempt;
    }
    attempt.rejection = Rejection::none;
    attempt.report = report_step(model_, rows_, attempt.state, step.dt, max_stiffness, pool_);
    static_cast<StepCounts&>(attempt.report) = result;
    attempt.report.largest_displacement = moved;
    attempt.report.remaining_dilation = remaining_dilation(model_, result.contacts, step.contacts.contacts,
                                                           attempt.state.contacts.contacts, pool_);
    attempt.report.ended_counter_slips =
        ended_counter_slips(model_, step.segments, step.contacts.contacts, attempt.state.contacts.contacts);
    return attempt;
}

void TimeStepper::correct_mid_step(const Stage& stage, const State& state, const StepEquations& step,
                                   OpenCloseResult& result, Prediction& prediction) {
    const PerBlock<Vec6> displacement =
        rows_.of_all_blocks(step.prescribed.displacement, result.displacement);
    const double moved = largest_displacement(state.blocks, model_.topology, displacement, pool_);
    if (!(moved <= scale_.displacement_limit(stage.control))) return;
    prediction.widen_for(moved);
    correct_rotations(displacement, {step.contacts.contacts, std::move(result.contacts)}, prediction);
}

bool TimeStepper::correct_motion(const State& state, const StepEquations& step, OpenCloseResult& result,
                                 const PerBlock<Vec6>& displacement, double moved, Prediction& prediction) {
    if (prediction.is_outrun_by(moved)) {
        prediction.widen_for(moved);
        prediction.needs_retry = true;
        return true;
    }
    if (prediction.rotation_corrections >= rotation_correction_limit ||
        !rotation_prediction_failed(prediction.predicted, displacement, step.springs, step.contacts.contacts,
                                    result, state.energy.kinetic))
        return false;
    correct_rotations(displacement, {step.contacts.contacts, std::move(result.contacts)}, prediction);
    return true;
}

bool TimeStepper::is_too_stiff_for_rounding(const StepEquations& step) const {
    return scale_.mean_weight > 0 && scale_.coordinate_rounding * max_spring_stiffness(step.springs) >
                                         rounding_force_limit * scale_.mean_weight;
}

std::vector<UndetectedPenetration> TimeStepper::undetected_penetrations(const Stage& stage,
                                                                        const State& before,
                                                                        const State& after,
                                                                        double search_radius) const {
    const double dt = after.stage_time - before.stage_time;
    const double shorter = hopeless_cut * stage.control.step / dt;
    const double depth = std::clamp(undetected_depth * shorter, undetected_depth, largest_undetected_depth);
    const PenetrationTest test{.before = before.blocks.vertices,
                               .after = after.blocks.vertices,
                               .candidates = after.contacts.candidates,
                               .contacts = after.contacts.contacts,
                               .search_radius = search_radius,
                               .tolerance = depth * scale_.edge_length,
                               .clip_depth = clipping_depth * scale_.edge_length};
    return find_undetected_penetrations(model_, test, pool_);
}

void TimeStepper::analyze_pattern(const ContactSet& contacts) {
    if (pattern_.size == rows_.count() && contacts.candidates == pattern_candidates_) return;
    pattern_candidates_ = contacts.candidates;
    std::vector<std::pair<RowIndex, RowIndex>> pairs;
    const auto add = [&](BlockIndex first_block, BlockIndex second_block) {
        const RowIndex i = rows_.row_of[first_block];
        const RowIndex j = rows_.row_of[second_block];
        if (i.exists() && j.exists() && i != j && (pairs.empty() || pairs.back() != std::pair{i, j}))
            pairs.emplace_back(i, j);
    };
    for (const auto& [corner, edge] : contacts.candidates)
        add(model_.topology.block_of[corner], model_.topology.block_of_edge(edge));
    for (const BoltSpec& bolt : model_.bolts)
        add(model_.material_points[bolt.first].block, model_.material_points[bolt.second].block);
    BlockPattern pattern = BlockPattern::from_pairs(rows_.count(), std::move(pairs));
    if (pattern == pattern_) return;
    pattern_ = std::move(pattern);
    solver_->analyze(pattern_);
}

OpenCloseResult TimeStepper::solve(const Stage& stage, const State& state, const StepEquations& step,
                                   const Prediction& prediction) {
    if (rows_.count() == 0) {
        OpenCloseResult no_unknowns;
        no_unknowns.converged = true;
        no_unknowns.contacts.resize(step.contacts.contacts.size());
        return no_unknowns;
    }
    analyze_pattern(step.contacts);
    end_of(Phase::analysis, work_.times);
    const PerContact<const EvaluatedContact*> initial_guess = prediction.guess.match(step.contacts.contacts);
    PerContact<double> held;
    if (bonds_hold(model_, stage)) held = held_shares(model_, step.contacts.contacts);
    StepProblem problem = step_problem(setting(), stage, state, step, row_contacts_);
    problem.guess = initial_guess;
    // The springs of augmented contacts are shifted anew in each attempt: no earlier displacement balances
    // them.
    PerRow<Vec6> found;
    if (prediction.has_guess() && model_.penetration_tolerance == 0)
        for (const RowIndex row : rows_.rows()) found.push_back(prediction.predicted[rows_.block_of[row]]);
    problem.found = found;
    problem.displacement_limit = scale_.displacement_limit(stage.control);
    problem.held_shares = held;
    problem.may_predict_anew = prediction.rotation_corrections < rotation_correction_limit;
    return solve_contacts(problem, pattern_, *solver_, work_, pool_);
}

bool TimeStepper::friction_drives(const Stage& stage, const State& before, const State& after) const {
    if (stage.is_static()) return false;
    const double dt = after.time - before.time;
    const double given = after.energy.friction_returned - before.energy.friction_returned;
    return dt > shortest_for_gain * stage.control.step && given > rejected_gain * turned_over(after.energy);
}

State TimeStepper::updated_state(const Stage& stage, const State& state, const StepEquations& step,
                                 const OpenCloseResult& result, BlockSpan<const Vec6> displacement) const {
    State after{state, step.contacts};
    after.time += step.dt;
    after.dynamic_time = step.loads.time;
    after.stage_time += step.dt;
    ++after.step_count;
    after.bolt_force = result.bolt_force;
    after.boundary_reactions =
        advance_reactions(model_, step.mid, stage, displacement, std::move(after.boundary_reactions));
    after.free_fields = step.fields;

    const double factor = velocity_factor(stage);
    pool_.parallel_for(rows_.count(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            const BlockIndex b = rows_.block_of[row];
            const Vec6& v0 = state.blocks.velocity[b];
            const Vec6& a0 = state.blocks.acceleration[b];
            const Vec6 a1 = step.newmark.acceleration(result.displacement[row], v0, a0);
            after.blocks.velocity[b] = factor * step.newmark.velocity(v0, a0, a1);
            after.blocks.acceleration[b] = a1;
        }
    });
    for (const BlockIndex b : model_.blocks()) {
        if (model_.motion[b] != Motion::prescribed || stage.is_static()) continue;
        after.blocks.velocity[b] += step.prescribed.velocity_change[b];
        after.blocks.acceleration[b] = step.prescribed.acceleration[b];
    }
    const PerBlock<Vec6> velocity = after.blocks.velocity;
    move_blocks(model_, displacement, pool_, after.blocks);
    double straining_loss = 0;
    for (const BlockIndex b : rows_.block_of) {
        straining_loss +=
            conserve_angular_momentum(state.blocks.mass[b], state.blocks.moments[b], velocity[b],
                                      after.blocks.moments[b], after.blocks.velocity[b]);
    }

    advance_contacts(model_,
                     {.segments = step.segments,
                      .vertices = after.blocks.vertices,
                      .evaluated = result.contacts,
                      .springs = step.springs,
                      .time = stage.time_of_step(step.dt),
                      .bonds_hold = bonds_hold(model_, stage)},
                     pool_, after.contacts.contacts);
    record_energy(stage, state, step, result, after);
    after.energy.numerical_loss += straining_loss;
    return after;
}

void TimeStepper::record_energy(const Stage& stage, const State& state, const StepEquations& step,
                                const OpenCloseResult& result, State& after) const {
    const StepWork work{state.blocks,
                        step.mid,
                        step.contacts.contacts,
                        step.segments,
                        step.springs,
                        step.dashpots,
                        step.bolts,
                        state.bolt_force,
                        step.boundaries,
                        result,
                        step.newmark,
                        stage.mass_damping,
                        velocity_factor(stage),
                        after.time,
                        step.loads,
                        stage.time_of_step(step.dt).duration()};
    ledger_.record_step(work, state.contacts.contacts, after);
}

}  // namespace rockslope::dda
