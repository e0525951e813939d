#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/analysis/step_report.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// `not_written`: the results could not be kept, which is the observer's to find out.
enum class RunStatus { completed, not_converged, not_settled, stopped, not_written };

struct RunOutcome {
    RunStatus status = RunStatus::completed;
    std::string message;                   ///< one line: reason, time, worst contact
    std::optional<Contact> worst_contact;  ///< at the refused step's start, when one is to blame
};

/// What came of one trial of a strength reduction.
struct ReductionTrial {
    double factor = 1;  ///< that strengths were divided by
    bool stands = false;
    std::int64_t steps = 0;
    double unbalanced_force = 0;  ///< at its end, over the weight
    double displacement = 0;      ///< m, of the block that moved farthest
};

/// What a run tells the outside: results, progress. Return values steer it.
class RunObserver {
  public:
    virtual ~RunObserver() = default;
    /// What the stage before set to count anew counts from this state.
    virtual void stage_begins(const Model&, const State&, const Stage&, int /*stage_index*/) {}
    /// After every accepted step. Returning false stops the run (status `stopped`).
    virtual bool step_done(const Model&, const State&, const Stage&, const StepReport&) { return true; }
    virtual void stage_ends(const Model&, const State&, const Stage&, int /*stage_index*/) {}
    /// After every step of a strength reduction's trials, in place of step_done().
    virtual bool trial_step_done(const Model&, const State&, const Stage&, const StepReport&) { return true; }
    virtual void trial_done(const Model&, const State&, const Stage&, const ReductionTrial&) {}
    /// The state in which the trial of the smallest failing factor ended.
    virtual void mechanism_found(const Model&, const State&, const Stage&) {}
    /// In place of stage_ends() when a stage does not converge or settle. @param state the last accepted
    /// step.
    virtual void stage_fails(const Model&, const State& /*state*/, const Stage&, int /*stage_index*/) {}
};

struct RunOptions {
    int threads = 1;
    int first_stage = 0;   ///< the stages before it are done
    bool resumed = false;  ///< the state is in the middle of first_stage
};

/// The state before the first step of a run.
State initial_state(const Model& model);

/// Runs the stages one after the other on `state`, which always holds the last accepted step.
RunOutcome run(const Model& model, std::span<const Stage> stages, State& state, RunObserver& observer,
               const RunOptions& options = {});

}  // namespace rockslope::dda
