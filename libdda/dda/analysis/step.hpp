#pragma once

#include <memory>
#include <optional>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/ledger.hpp"
#include "dda/analysis/step_equations.hpp"
#include "dda/analysis/step_report.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/contact/undetected_penetration.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/solve/open_close_iteration.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// Why a step was rejected.
enum class Rejection {
    none,
    not_converged,           ///< the open-close iteration reached its limit
    singular,                ///< the matrix is not positive definite
    turning_otherwise,       ///< a block turns so fast that no prediction of its mid-step is right
    excessive_displacement,  ///< a vertex moves farther than the displacement ratio allows, or no
                             ///< prediction fits the motion
    undetected_penetration,  ///< a vertex penetrates a block without a contact
    driving_friction,        ///< friction gives energy
    too_stiff                ///< rounding of coordinates changes a force by a tenth of the mean block weight
};

/// The result of one trial step.
struct StepAttempt {
    Rejection rejection = Rejection::none;
    /// not_converged: the contact with the largest force change, at the start of the step.
    /// undetected_penetration: the deepest penetration, at the end of the step.
    std::optional<Contact> worst_contact;
    /// turning_otherwise: the block, and its rotation in the step, rad.
    BlockIndex turning_block = BlockIndex::none();
    double rotation = 0;
    State state;  ///< the state at the end of the step, if accepted
    StepReport report;
};

/// Advances a state by one time step. Its members are constants and work space: the result depends on the
/// arguments alone.
class TimeStepper {
  public:
    /// Prepares the work space of a model. @param threads number of threads that a step uses.
    TimeStepper(const Model& model, int threads);

    /// Tries a step of size dt, s. `state` is not changed; the result holds the new state or the reason for
    /// the rejection.
    StepAttempt advance(const Stage& stage, const State& state, double dt);

    /// The energies of the run so far.
    const Ledger& ledger() const { return ledger_; }
    /// Adds the run times of all further steps to `times`; null: no timing.
    void time_phases(PhaseTimes* times) { work_.times = times; }

  private:
    StepSetting setting() const { return {model_, rows_, scale_, pool_, work_.times}; }
    /// Computes the step with one prediction. Where the solution contradicts the prediction, corrects the
    /// prediction and sets its `needs_retry`.
    StepAttempt attempt_with(const Stage& stage, const State& state, double dt, Prediction& prediction);
    /// Corrects the search radius or the predicted rotations if the displacements found contradict them.
    /// @param moved m, the largest displacement of a vertex. @return whether the prediction was corrected.
    static bool correct_motion(const State& state, const StepEquations& step, OpenCloseResult& result,
                               const PerBlock<Vec6>& displacement, double moved, Prediction& prediction);
    /// Predicts the mid-step with the displacements found, where gaps did not settle about the one predicted.
    void correct_mid_step(const Stage& stage, const State& state, const StepEquations& step,
                          OpenCloseResult& result, Prediction& prediction);
    /// Whether the rounding of coordinates alone changes spring forces by a tenth of the mean block weight.
    bool is_too_stiff_for_rounding(const StepEquations& step) const;
    /// Vertices that penetrate a block without a contact at the end of the step, or passed through it.
    std::vector<UndetectedPenetration> undetected_penetrations(const Stage& stage, const State& before,
                                                               const State& after,
                                                               double search_radius) const;
    /// Symbolic analysis of the matrix pattern, if the pattern of the candidates has changed.
    void analyze_pattern(const ContactSet& contacts);
    OpenCloseResult solve(const Stage& stage, const State& state, const StepEquations& step,
                          const Prediction& prediction);
    /// Whether friction gives so much energy in a step that a shorter one is to be tried.
    bool friction_drives(const Stage& stage, const State& before, const State& after) const;
    State updated_state(const Stage& stage, const State& state, const StepEquations& step,
                        const OpenCloseResult& result, BlockSpan<const Vec6> displacement) const;
    /// Adds the step to the energy balance of the state at its end.
    void record_energy(const Stage& stage, const State& state, const StepEquations& step,
                       const OpenCloseResult& result, State& after) const;

    const Model& model_;
    ThreadPool pool_;
    RowMap rows_;
    ModelScale scale_;
    Ledger ledger_;
    BlockPattern pattern_;
    std::vector<CornerEdge> pattern_candidates_;  ///< the candidates that pattern_ was computed from
    IterationWorkspace work_;
    RowContacts row_contacts_;
    std::unique_ptr<LinearSolver> solver_;
};

}  // namespace rockslope::dda
