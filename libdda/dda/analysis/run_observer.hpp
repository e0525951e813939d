#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "dda/analysis/state.hpp"
#include "dda/analysis/step_report.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// How a run ended. `energy_created`: friction returned more energy than a result can be right with, see
/// creates_energy(). `not_written`: results could not be written; the observer sets it. `collapsed`: a
/// displacement passed the limit of the stage, which is a result and no failure.
enum class RunStatus {
    completed,
    not_converged,
    not_settled,
    energy_created,
    stopped,
    not_written,
    collapsed
};

/// What passed the displacement limit of a stage.
struct Collapse {
    std::string point;        ///< name of a measured point; empty: a block
    BlockIndex block;         ///< that moved, or that the point is in
    double displacement = 0;  ///< m, less that of the reference
    double limit = 0;         ///< m
    Vec2 at = Vec2::Zero();   ///< m, where it is now, in the user's coordinates
    double time = 0;          ///< s since the start of the run
};

struct RunOutcome {
    RunStatus status = RunStatus::completed;
    std::string message;                    ///< one line: reason, time, worst contact
    std::optional<Contact> worst_contact;   ///< if a contact is the cause, see StepAttempt
    std::optional<Collapse> collapse = {};  ///< with the status `collapsed`
};

/// The result of one trial of a strength reduction.
struct ReductionTrial {
    double factor = 1;  ///< strengths were divided by it
    bool stands = false;
    std::int64_t steps = 0;
    double unbalanced_force = 0;  ///< at the end of the trial, over the weight
    double displacement = 0;      ///< m, the largest of a block's centroid
};

/// Receives the results and the progress of a run. Its return values can stop the run.
class RunObserver {
  public:
    virtual ~RunObserver() = default;
    /// Before the first step of a stage. Displacements and histories that the previous stage resets are
    /// reset.
    virtual void stage_begins(const Model&, const State&, const Stage&, int /*stage_index*/) {}
    /// After every accepted step. Returning false stops the run (status `stopped`).
    virtual bool step_done(const Model&, const State&, const Stage&, const StepReport&) { return true; }
    /// After the last step of a stage.
    virtual void stage_ends(const Model&, const State&, const Stage&, int /*stage_index*/) {}
    /// Replaces step_done() in the trials of a strength reduction.
    virtual bool trial_step_done(const Model&, const State&, const Stage&, const StepReport&) { return true; }
    /// After each trial of a strength reduction.
    virtual void trial_done(const Model&, const State&, const Stage&, const ReductionTrial&) {}
    /// Receives the final state of the failed trial with the smallest factor: the failure mechanism.
    virtual void mechanism_found(const Model&, const State&, const Stage&) {}
    /// Replaces stage_ends() when a stage does not converge or settle, or creates energy. @param state after
    /// the last accepted step.
    virtual void stage_fails(const Model&, const State& /*state*/, const Stage&, int /*stage_index*/) {}
};

}  // namespace rockslope::dda
