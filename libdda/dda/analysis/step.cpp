#include "dda/analysis/step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dda/analysis/advance_contacts.hpp"
#include "dda/analysis/base_motion.hpp"
#include "dda/analysis/bonds.hpp"
#include "dda/analysis/energy_watch.hpp"
#include "dda/analysis/rotation_prediction.hpp"
#include "dda/analysis/shear_sharing.hpp"
#include "dda/contact/candidates.hpp"
#include "dda/contact/find_contacts.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

namespace {

/// Largest number of attempts at a step. Another one follows when a vertex moves by more than half of the
/// search radius, when one penetrates undetected, or when the predicted rotations were wrong.
constexpr int attempt_limit = 8;
/// Largest number of attempts repeated because of wrong rotations. Each one reduces the rotation error by a
/// factor of about the rotation, rad.
constexpr int rotation_correction_limit = 3;
/// Tolerated penetration of a vertex without a contact at the end of a step, over the median edge length. Far
/// below any penetration that matters, far above rounding. In a step that was cut to less than a thousandth
/// the tolerance is larger by as much as the step is shorter, up to the second value: a depth that such steps
/// do not prevent is none to end a run for.
constexpr double undetected_depth = 1e-9;
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

/// Friction that gives energy in a step by more than this fraction of what was turned over so far has its
/// dilation limited.
constexpr double tolerated_gain = 1e-7;
/// A step in which friction still gives energy, by more than this fraction, is cut: a rough block that lands
/// on one end turns the joint's forces round in it. It is accepted where the step is as short as the second
/// value, over that of the control.
constexpr double rejected_gain = 1e-4;
constexpr double shortest_for_gain = 1.0 / 20;

double extent(CornerSpan<const Vec2> vertices, int axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vec2& v : vertices) {
        low = std::min(low, v[axis]);
        high = std::max(high, v[axis]);
    }
    return high - low;
}

double largest_coordinate(CornerSpan<const Vec2> vertices) {
    double largest = 0;
    for (const Vec2& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    return largest;
}

/// The mean weight of the blocks with unknowns, N per metre.
double mean_weight(const Model& model, const RowMap& rows) {
    if (rows.count() == 0) return 0;
    const BlockSystem blocks = initial_block_system(model);
    double mass = 0;
    for (const BlockIndex block : rows.block_of) mass += blocks.mass[block];
    return mass * model.gravity.norm() / rows.count();
}

double velocity_factor(const Stage& stage) {
    return stage.is_static() ? 0.0 : stage.dynamic_coefficient;
}

/// The physical time of a step, s: dt in dynamic stages, 0 in static ones.
double duration_of(const Stage& stage, double dt) {
    return stage.is_static() ? 0 : dt;
}

/// The time at which load histories are evaluated, s: the end of the step.
double load_time(const Stage& stage, const State& state, double dt) {
    return state.dynamic_time + duration_of(stage, dt);
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

}  // namespace

struct TimeStepper::Step {
    double dt = 0;
    Newmark newmark;
    PrescribedMotion prescribed;
    MidStep mid;
    ContactSet contacts;
    JointSegments segments;
    PerContact<ContactSprings> springs;
    PerContact<NormalDashpot> dashpots;
    std::vector<BoltSpring> bolts;
    FreeFieldMotions fields;
    std::vector<BoundaryTerm> boundaries;
    LoadInstant loads;
    BaseSystem base;
};

TimeStepper::TimeStepper(const Model& model, int threads)
    : model_(model),
      pool_(threads),
      rows_(model.motion),
      ledger_(model_, rows_),
      half_height_(extent(model.vertices, 1) / 2),
      mean_weight_(mean_weight(model, rows_)),
      coordinate_rounding_(8 * std::numeric_limits<double>::epsilon() * largest_coordinate(model.vertices)),
      solver_(make_linear_solver(model.solver, pool_)) {
    edge_length_ = median_edge_length(model.topology, model.vertices);
}

StepAttempt TimeStepper::advance(const Stage& stage, const State& state, double dt) {
    StepAttempt attempt;
    StepCounts counts;
    if (times_ != nullptr) times_->start();
    Prediction prediction = initial_prediction(stage, state, dt);
    for (int attempts = 0; attempts < attempt_limit && prediction.needs_retry; ++attempts) {
        attempt = attempt_with(stage, state, dt, prediction);
        counts += attempt.report;
    }
    end_of(Phase::update, times_);
    static_cast<StepCounts&>(attempt.report) = counts;
    return attempt;
}

StepAttempt TimeStepper::attempt_with(const Stage& stage, const State& state, double dt,
                                      Prediction& prediction) {
    StepAttempt attempt;
    prediction.needs_retry = false;
    Step step = prepare(stage, state, dt, prediction);
    if (is_too_stiff_for_rounding(step)) {
        attempt.rejection = Rejection::too_stiff;
        return attempt;
    }
    OpenCloseResult result = solve(stage, state, step, prediction);
    static_cast<StepCounts&>(attempt.report) = result;
    if (!result.converged) {
        if (result.gaps_unsettled) correct_mid_step(stage, state, step, result, prediction);
        attempt.rejection = result.singular ? Rejection::singular : Rejection::not_converged;
        if (result.worst_contact.exists())
            attempt.worst_contact = step.contacts.contacts[result.worst_contact];
        return attempt;
    }
    const PerBlock<Vec6> displacement = all_displacements(step, result);
    const double moved = largest_displacement(state.blocks, model_.topology, displacement, pool_);
    attempt.report.largest_displacement = moved;
    attempt.rejection = Rejection::excessive_displacement;  // stays so if no prediction fits the motion
    if (!(moved <= displacement_limit(stage.control))) return attempt;  // also if it is not a number
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
    attempt.report = report_step(model_, rows_, attempt.state, step.dt, max_stiffness);
    static_cast<StepCounts&>(attempt.report) = result;
    attempt.report.largest_displacement = moved;
    attempt.report.remaining_dilation =
        remaining_dilation(model_, result.contacts, step.contacts.contacts, attempt.state.contacts.contacts);
    attempt.report.ended_counter_slips =
        ended_counter_slips(model_, step.segments, step.contacts.contacts, attempt.state.contacts.contacts);
    return attempt;
}

void TimeStepper::correct_mid_step(const Stage& stage, const State& state, const Step& step,
                                   OpenCloseResult& result, Prediction& prediction) {
    const PerBlock<Vec6> displacement = all_displacements(step, result);
    const double moved = largest_displacement(state.blocks, model_.topology, displacement, pool_);
    if (!(moved <= displacement_limit(stage.control))) return;
    ++prediction.rotation_corrections;
    prediction.widen_for(moved);
    prediction.retry_from(displacement, {step.contacts.contacts, std::move(result.contacts)});
}

bool TimeStepper::correct_motion(const State& state, const Step& step, OpenCloseResult& result,
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
    ++prediction.rotation_corrections;
    prediction.retry_from(displacement, {step.contacts.contacts, std::move(result.contacts)});
    return true;
}

bool TimeStepper::is_too_stiff_for_rounding(const Step& step) const {
    return mean_weight_ > 0 &&
           coordinate_rounding_ * max_spring_stiffness(step.springs) > rounding_force_limit * mean_weight_;
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
                               .tolerance = depth * edge_length_,
                               .clip_depth = clipping_depth * edge_length_};
    return find_undetected_penetrations(model_, test, pool_);
}

Prediction TimeStepper::initial_prediction(const Stage& stage, const State& state, double dt) const {
    PerBlock<Vec6> free_motion(state.blocks.velocity);
    for (Vec6& displacement : free_motion) displacement *= dt;
    // A static step is longer than the control's where its displacements stay as small, Eq. (41).
    const double fall = std::min(dt, stage.control.step);
    Prediction prediction;
    prediction.search_radius = initial_search_radius(
        state.contacts.contacts,
        {.motion = largest_displacement(state.blocks, model_.topology, free_motion, pool_),
         .change = 2 * model_.gravity.norm() * fall * fall,
         .limit = displacement_limit(stage.control),
         .rounding = 1e-4 * edge_length_});
    prediction.predicted =
        prescribe_motion(model_, stage, state.blocks, dt, state.stage_time + dt).displacement;
    for (const BlockIndex b : rows_.block_of) prediction.predicted[b] = free_motion[b];
    return prediction;
}

TimeStepper::Step TimeStepper::prepare(const Stage& stage, const State& state, double dt,
                                       const Prediction& prediction) {
    Step step;
    step.dt = dt;
    step.newmark = {stage.newmark_beta, stage.newmark_gamma, dt};
    step.prescribed = prescribe_motion(model_, stage, state.blocks, dt, state.stage_time + dt);
    step.mid = predict_mid_step(model_, state.blocks, prediction.predicted, pool_);
    end_of(Phase::preparation, times_);
    FoundContacts found =
        find_contacts(model_, state.contacts,
                      {state.blocks.vertices, step.mid.vertices, prediction.forced, prediction.search_radius,
                       edge_length_, undetected_depth * edge_length_ + coordinate_rounding_,
                       duration_of(stage, dt), state.step_count == 0},
                      pool_, times_);
    step.contacts = std::move(found.set);
    step.segments = std::move(found.segments);
    share_shear_force(model_, step.segments, step.contacts.contacts);
    step.springs =
        contact_springs(model_, rows_, step.mid, step.prescribed.displacement, step.contacts.contacts, pool_);
    row_contacts_.find(rows_.count(), step.springs);
    if (!stage.is_static())
        step.dashpots = contact_dashpots(model_, {rows_, state.blocks, step.mid}, step.newmark,
                                         {step.contacts.contacts, step.springs, row_contacts_}, pool_);
    step.bolts = bolt_springs(model_, rows_, step.mid, step.prescribed.displacement);
    const StageInstant end{.stage = stage, .time = state.stage_time + dt};
    step.fields = advance_fields(model_, end, state.blocks, state.free_fields, step.newmark);
    step.boundaries = boundary_terms(model_, rows_, step.mid, end, state.boundary_reactions, step.fields);
    step.loads = {load_time(stage, state, dt), frame_acceleration_over_step(stage, dt, end.time)};
    assemble_base(stage, state, step);
    end_of(Phase::preparation, times_);
    return step;
}

void TimeStepper::assemble_base(const Stage& stage, const State& state, Step& step) const {
    const std::size_t count = rows_.count();
    step.base.stiffness.assign(count, Mat6::Zero());
    step.base.load.assign(count, Vec6::Zero());
    add_inertia(rows_, state.blocks, step.newmark, stage.mass_damping, step.base);
    add_elasticity(model_, rows_, state.blocks, step.dt, step.base);
    add_loads(model_, rows_, state.blocks, step.mid, step.loads, step.base);
    add_fixed_points(model_, rows_, state.blocks, step.mid, step.base);
    add_boundaries(step.boundaries, rows_, state.blocks, step.newmark, step.base);
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

OpenCloseResult TimeStepper::solve(const Stage& stage, const State& state, const Step& step,
                                   const Prediction& prediction) {
    if (rows_.count() == 0) {
        OpenCloseResult no_unknowns;
        no_unknowns.converged = true;
        no_unknowns.contacts.resize(step.contacts.contacts.size());
        return no_unknowns;
    }
    analyze_pattern(step.contacts);
    end_of(Phase::analysis, times_);
    const PerContact<const EvaluatedContact*> initial_guess = prediction.guess.match(step.contacts.contacts);
    PerContact<double> held;
    if (bonds_hold(model_, stage)) held = held_shares(model_, step.contacts.contacts);
    const StepProblem problem{
        model_,
        stage.control,
        rows_,
        step.base,
        state.blocks,
        step.prescribed.displacement,
        step.contacts.contacts,
        step.segments,
        initial_guess,
        step.springs,
        row_contacts_,
        step.bolts,
        state.bolt_force,
        duration_of(stage, step.dt),
        coordinate_rounding_ * std::max(max_spring_stiffness(step.springs), model_.normal_penalty),
        step.dashpots,
        held,
        tolerated_gain * turned_over(state.energy),
        prediction.rotation_corrections < rotation_correction_limit,
        stage.is_static()};
    return iterate_open_close(problem, pattern_, *solver_, work_, pool_, times_);
}

bool TimeStepper::friction_drives(const Stage& stage, const State& before, const State& after) const {
    if (stage.is_static()) return false;
    const double dt = after.time - before.time;
    const double given = after.energy.friction_returned - before.energy.friction_returned;
    return dt > shortest_for_gain * stage.control.step && given > rejected_gain * turned_over(after.energy);
}

PerBlock<Vec6> TimeStepper::all_displacements(const Step& step, const OpenCloseResult& result) const {
    PerBlock<Vec6> displacement = step.prescribed.displacement;
    for (const RowIndex row : rows_.rows()) displacement[rows_.block_of[row]] = result.displacement[row];
    return displacement;
}

State TimeStepper::updated_state(const Stage& stage, const State& state, const Step& step,
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
    for (const RowIndex row : rows_.rows()) {
        const BlockIndex b = rows_.block_of[row];
        const Vec6& v0 = state.blocks.velocity[b];
        const Vec6& a0 = state.blocks.acceleration[b];
        const Vec6 a1 = step.newmark.acceleration(result.displacement[row], v0, a0);
        after.blocks.velocity[b] = factor * step.newmark.velocity(v0, a0, a1);
        after.blocks.acceleration[b] = a1;
    }
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
                      .duration = duration_of(stage, step.dt),
                      .bonds_hold = bonds_hold(model_, stage)},
                     pool_, after.contacts.contacts);
    record_energy(stage, state, step, result, after);
    after.energy.numerical_loss += straining_loss;
    return after;
}

void TimeStepper::record_energy(const Stage& stage, const State& state, const Step& step,
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
                        duration_of(stage, step.dt)};
    ledger_.record_step(work, state.contacts.contacts, after);
}

}  // namespace rockslope::dda
