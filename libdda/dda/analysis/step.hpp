#pragma once

#include <memory>
#include <optional>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/ledger.hpp"
#include "dda/analysis/open_close_iteration.hpp"
#include "dda/analysis/prediction.hpp"
#include "dda/analysis/state.hpp"
#include "dda/analysis/step_report.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/contact/undetected_penetration.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// Why a step was rejected.
enum class Rejection {
    none,
    not_converged,           ///< the open-close iteration reached its limit
    singular,                ///< the matrix is not positive definite
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
    void time_phases(PhaseTimes* times) { times_ = times; }

  private:
    /// The equations of a step: all that is constant during its open-close iteration.
    struct Step;

    /// Computes the step with one prediction. Where the solution contradicts the prediction, corrects the
    /// prediction and sets its `needs_retry`.
    StepAttempt attempt_with(const Stage& stage, const State& state, double dt, Prediction& prediction);
    Prediction initial_prediction(const Stage& stage, const State& state, double dt) const;
    /// Corrects the search radius or the predicted rotations if the displacements found contradict them.
    /// @param moved m, the largest displacement of a vertex. @return whether the prediction was corrected.
    static bool correct_motion(const State& state, const Step& step, OpenCloseResult& result,
                               const PerBlock<Vec6>& displacement, double moved, Prediction& prediction);
    /// Predicts the mid-step with the displacements found, where gaps did not settle about the one predicted.
    void correct_mid_step(const Stage& stage, const State& state, const Step& step, OpenCloseResult& result,
                          Prediction& prediction);
    /// The largest displacement that a vertex may have in a step, m.
    double displacement_limit(const StepControl& control) const {
        return control.displacement_ratio * half_height_;
    }
    /// Detects and transfers contacts, and assembles all terms that are constant during the iteration.
    Step prepare(const Stage& stage, const State& state, double dt, const Prediction& prediction);
    /// Whether the rounding of coordinates alone changes spring forces by a tenth of the mean block weight.
    bool is_too_stiff_for_rounding(const Step& step) const;
    /// Vertices that penetrate a block without a contact at the end of the step, or passed through it.
    std::vector<UndetectedPenetration> undetected_penetrations(const Stage& stage, const State& before,
                                                               const State& after,
                                                               double search_radius) const;
    /// Inertia, elasticity, loads, fixed points and viscous boundaries.
    void assemble_base(const Stage& stage, const State& state, Step& step) const;
    /// Symbolic analysis of the matrix pattern, if the pattern of the candidates has changed.
    void analyze_pattern(const ContactSet& contacts);
    OpenCloseResult solve(const Stage& stage, const State& state, const Step& step,
                          const Prediction& prediction);
    /// Whether friction gives so much energy in a step that a shorter one is to be tried.
    bool friction_drives(const Stage& stage, const State& before, const State& after) const;
    /// The displacement of the step per block, prescribed and fixed blocks included.
    PerBlock<Vec6> all_displacements(const Step& step, const OpenCloseResult& result) const;
    State updated_state(const Stage& stage, const State& state, const Step& step,
                        const OpenCloseResult& result, BlockSpan<const Vec6> displacement) const;
    /// Adds the step to the energy balance of the state at its end.
    void record_energy(const Stage& stage, const State& state, const Step& step,
                       const OpenCloseResult& result, State& after) const;

    const Model& model_;
    ThreadPool pool_;
    RowMap rows_;
    Ledger ledger_;
    double half_height_ = 0;          ///< m, half the height of the model
    double mean_weight_ = 0;          ///< N per metre, mean weight of a block with unknowns
    double coordinate_rounding_ = 0;  ///< m, rounding error of a coordinate
    double edge_length_ = 0;          ///< m, median of the block edges
    BlockPattern pattern_;
    std::vector<CornerEdge> pattern_candidates_;  ///< the candidates that pattern_ was computed from
    IterationWorkspace work_;
    RowContacts row_contacts_;
    std::unique_ptr<LinearSolver> solver_;
    PhaseTimes* times_ = nullptr;
};

}  // namespace rockslope::dda
