#include "dda/analysis/run_stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "dda/analysis/bonds.hpp"
#include "dda/analysis/deepest_contact.hpp"
#include "dda/analysis/energy_watch.hpp"
#include "dda/analysis/lost_blocks.hpp"
#include "dda/analysis/moving_block.hpp"
#include "dda/analysis/stop_limit.hpp"

namespace rockslope::dda {

namespace {

std::string describe(const Model& model, const StepAttempt& attempt) {
    char text[256];
    switch (attempt.rejection) {
        case Rejection::singular:
            return "the equations are not positive definite";
        case Rejection::turning_otherwise:
            std::snprintf(text, sizeof text,
                          "block %d turns by %.3g rad in one step, otherwise than predicted",
                          attempt.turning_block.value(), attempt.rotation);
            return text;
        case Rejection::excessive_displacement:
            std::snprintf(text, sizeof text, "a vertex moves %.3g m in one step",
                          attempt.report.largest_displacement);
            return text;
        case Rejection::driving_friction:
            return "friction gives energy";
        case Rejection::too_stiff:
            return "the contact springs are too stiff: rounding of the coordinates alone changes a force by "
                   "a tenth of a block's weight; use smaller penalties or joint stiffnesses";
        default:
            break;
    }
    if (!attempt.worst_contact) return "the open-close iteration does not converge";
    const Contact& contact = *attempt.worst_contact;
    if (attempt.rejection == Rejection::undetected_penetration) {
        std::snprintf(text, sizeof text,
                      "a vertex of block %d penetrates block %d by %.3g m at (%.6g, %.6g), and no contact "
                      "was detected",
                      contact.corner_block.value(), contact.edge_block.value(), -contact.gap,
                      contact.point.x() + model.origin.x(), contact.point.y() + model.origin.y());
        return text;
    }
    std::snprintf(text, sizeof text,
                  "the open-close iteration does not converge; worst contact: block %d on block %d at (%.6g, "
                  "%.6g), joint material %s",
                  contact.corner_block.value(), contact.edge_block.value(),
                  contact.point.x() + model.origin.x(), contact.point.y() + model.origin.y(),
                  model.joint_material_at(contact.joint_material).name.c_str());
    return text;
}

/// Most iterations of a step after which a static stage may lengthen its step, if none of them was of the
/// interior-point method. Where bonds hold, those that yield keep a step hard while next to nothing moves.
constexpr int easy_iterations = 20;
/// The largest step after one that was not easy, over that one; the step of the control is always permitted.
constexpr double after_hard_step = 0.7;
/// Largest step of a static stage over the step of its control.
constexpr double static_step_ratio = 50;
/// First step of a static stage over the step of its control. Blocks that fall far in the first steps
/// strike each other, and the slope loosens.
constexpr double first_static_step_ratio = 0.1;

/// A dynamic stage that takes so many steps in a row, each below this share of the stage's step, does not get
/// on: at a step of 5 ms they are a millisecond.
constexpr double crawling_share = 1e-4;
constexpr std::int64_t crawling_steps = 2000;

/// Adapts the step, Eq. (41): cut after a rejection, grown after steps that needed none. A static stage has
/// no time to resolve: its step grows as long as no vertex moves farther in it than a body falls from rest in
/// the step of the stage's control.
class StepSize {
  public:
    /// @param acceleration m/s2, of a body that nothing holds; @param resume s, the size to begin with; 0:
    /// none.
    /// @param bonds_hold whether bonds hold in the stage.
    StepSize(const Stage& stage, double acceleration, bool bonds_hold, double resume)
        : control_(stage.control),
          is_static_(stage.is_static()),
          bonds_hold_(bonds_hold),
          free_fall_(acceleration * control_.step * control_.step / 2),
          size_(resume > 0 ? resume : first_step()) {
        size_ = std::min(size_, is_static_ ? static_step_ratio * control_.step : control_.step);
    }
    /// The size of the next step, s. `remaining` is the time to an instant at which a step must end. If less
    /// than two steps remain, the remaining time is halved, so that no very small step is left.
    double next(double remaining) const {
        if (size_ >= remaining * (1 - 1e-9)) return remaining;
        return size_ * 2 > remaining ? remaining / 2 : size_;
    }
    void cut(double tried) { size_ = tried * control_.cut; }
    /// @param report of the accepted step, whose `cuts` are those before it.
    void accept(const StepReport& report) {
        const double largest = largest_after(report);
        size_ = std::min(report.cuts == 0 ? size_ * control_.growth : size_, largest);
    }
    double size() const { return size_; }
    bool too_small() const { return size_ < control_.smallest_step; }

  private:
    double first_step() const {
        if (!is_static_) return control_.step;
        return std::max(first_static_step_ratio * control_.step, control_.smallest_step);
    }
    /// The largest step after an accepted one, s. A displacement grows with the square of a static step at
    /// most.
    double largest_after(const StepReport& report) const {
        const bool is_easy =
            bonds_hold_ || (report.iterations <= easy_iterations && report.interior_iterations == 0);
        if (!is_static_) return control_.step;
        if (!is_easy) return std::max(control_.step, after_hard_step * report.step);
        const double longer = report.step * std::sqrt(free_fall_ / report.largest_displacement);
        return std::clamp(longer, control_.step, static_step_ratio * control_.step);
    }

    const StepControl& control_;
    bool is_static_;
    bool bonds_hold_;
    double free_fall_;  ///< m, what a body falls from rest in the control's step
    double size_;
};

/// The time to the instant at which a step of a dynamic stage must end, s: the next multiple of the stage's
/// step, or the end of the stage if that multiple is within half a step of it.
double until_next_instant(const Stage& stage, double stage_time) {
    const double instant = next_step_multiple(stage, stage_time);
    return (instant + stage.control.step / 2 < stage.duration ? instant : stage.duration) - stage_time;
}

/// Sets all velocities to zero at the end of a static stage. Blocks that still move keep their accelerations.
void stop(const Model& model, const Stage& stage, State& state) {
    const std::vector<BlockIndex> moving = moving_blocks(model, state, stage.tolerance);
    PerBlock<Vec6> accelerations(state.blocks.acceleration.size(), Vec6::Zero());
    for (const BlockIndex block : moving) accelerations[block] = state.blocks.acceleration[block];
    state.blocks.acceleration = std::move(accelerations);
    for (Vec6& v : state.blocks.velocity) v.setZero();
}

/// Why a static stage will not settle, in one line: a block moves too far, or too many steps were needed.
std::optional<std::string> settling_failure(const Model& model, const Stage& stage, const State& state) {
    const std::string beginning = "stage '" + stage.name + "' does not settle: ";
    if (const auto moving =
            block_moved_beyond(model, state, stage.displacement_limit, stage.moving_share, stage.tolerance))
        return beginning + describe(model, state, *moving, stage.tolerance);
    if (state.stage_steps < stage.step_limit) return {};
    const auto moving = least_balanced_block(model, state);
    return beginning + "after " + std::to_string(stage.step_limit) + " steps " +
           (moving ? describe(model, state, *moving, stage.tolerance) : "it is not in balance");
}

RunOutcome energy_failure(const Model& model, const Stage& stage, const State& state) {
    char text[128];
    std::snprintf(text, sizeof text, "stage '%s', t = %.9g s: ", stage.name.c_str(), state.time);
    return {RunStatus::energy_created, text + describe_returned(model, state.energy), {}};
}

RunOutcome crawling_failure(const Model& model, const Stage& stage, const State& state,
                            const StepAttempt& cut) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "stage '%s', t = %.9g s: the last %lld steps were each below %g of the stage's step",
                  stage.name.c_str(), state.time, static_cast<long long>(crawling_steps), crawling_share);
    // A run resumed just before has seen no cut.
    const std::string why = cut.rejection == Rejection::none ? "" : "; the last cut: " + describe(model, cut);
    return {RunStatus::not_converged, text + why, cut.worst_contact};
}

RunOutcome collapsed(const Model& model, const Stage& stage, const State& state, const Collapse& collapse) {
    return {RunStatus::collapsed, describe(model, stage, state, collapse), {}, collapse};
}

/// What the end of a static stage makes of the state at rest. @param holds whether bonds hold in the stage.
void come_to_rest(const Model& model, const Stage& stage, State& state, bool holds) {
    stop(model, stage, state);
    if (!holds) return;
    state.strained_bonds = strained_bonds(model, state);
    relax_held_bonds(model, state);
}

}  // namespace

void begin_stage(State& state) {
    state.stage_time = 0;
    state.next_step = 0;
    state.stage_steps = 0;
    state.short_steps = 0;
    state.strained_bonds = {};
    state.stage_origin.clear();
    for (const AreaMoments& moments : state.blocks.moments) state.stage_origin.push_back(moments.centroid);
}

RunOutcome run_stage(const Model& model, const Stage& stage, TimeStepper& stepper, State& state,
                     RunObserver& observer) {
    const bool is_static = stage.is_static();
    const bool holds = bonds_hold(model, stage);
    StepSize step(stage, reference_acceleration(model, state.blocks), holds, state.next_step);
    int cuts = 0;
    StepCounts counts;                                             // since the last accepted step
    StepAttempt last_cut;                                          // without its state
    if (const auto collapse = find_collapse(model, stage, state))  // of a run resumed after that step
        return collapsed(model, stage, state, *collapse);
    while (is_static || state.stage_time < stage.duration * (1 - 1e-12)) {
        const double dt = is_static ? step.size() : step.next(until_next_instant(stage, state.stage_time));
        StepAttempt attempt = stepper.advance(stage, state, dt);
        counts += attempt.report;
        if (attempt.rejection != Rejection::none) {
            ++cuts;
            step.cut(dt);
            if (!step.too_small()) {
                last_cut = std::move(attempt);
                last_cut.state = State();
                continue;
            }
            char text[128];
            std::snprintf(text, sizeof text,
                          "stage '%s', t = %.9g s: no step above %.3g s is accepted: ", stage.name.c_str(),
                          state.time, stage.control.smallest_step);
            return {RunStatus::not_converged, text + describe(model, attempt), attempt.worst_contact};
        }
        attempt.report.cuts = cuts;
        static_cast<StepCounts&>(attempt.report) = counts;
        step.accept(attempt.report);
        state = std::move(attempt.state);
        state.next_step = step.size();
        cuts = 0;
        counts = {};
        ++state.stage_steps;
        state.short_steps = dt < crawling_share * stage.control.step ? state.short_steps + 1 : 0;
        const bool bonds_break = holds && break_worst_bonds(model, state) > 0;
        attempt.report.at_rest = is_static && !bonds_break && is_at_rest(model, state, stage);
        if (attempt.report.at_rest) come_to_rest(model, stage, state, holds);
        note_deepest_contact(model, state);
        const std::vector<BlockIndex> lost = note_lost_blocks(model, state);
        if (!observer.step_done(model, state, stage, attempt.report))
            return {RunStatus::stopped, "stopped as asked", {}};
        if (const auto collapse = find_collapse(model, stage, state))
            return collapsed(model, stage, state, *collapse);
        if (attempt.report.at_rest) break;
        if (!lost.empty() && model.removes_lost_blocks) return {RunStatus::blocks_lost, {}, {}};
        if (!is_static && creates_energy(state.energy)) return energy_failure(model, stage, state);
        if (!is_static && state.short_steps >= crawling_steps)
            return crawling_failure(model, stage, state, last_cut);
        if (is_static)
            if (const auto failure = settling_failure(model, stage, state))
                return {RunStatus::not_settled, *failure, {}};
    }
    return {};
}

}  // namespace rockslope::dda
