#pragma once

#include <memory>
#include <optional>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/base_motion.hpp"
#include "dda/analysis/ledger.hpp"
#include "dda/analysis/open_close_iteration.hpp"
#include "dda/analysis/prediction.hpp"
#include "dda/analysis/run.hpp"
#include "dda/analysis/state.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/contact/undetected_penetration.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

enum class Rejection {
    none,
    not_converged,
    singular,
    excessive_displacement,
    undetected_penetration,
    too_stiff
};

/// What came of one attempt at a step.
struct StepAttempt {
    Rejection rejection = Rejection::none;
    /// When it did not converge: whose force moved most, at the step's start. When undetected_penetration:
    /// the corner that is largest_penetration in another block, at its end.
    std::optional<Contact> worst_contact;
    State state;  ///< the state at the step's end, when accepted
    StepReport report;
};

/// Advances a state by one time step. Holds only work space: what it returns depends on its arguments alone.
class TimeStepper {
  public:
    TimeStepper(const Model& model, int threads);

    /// One attempt at a step of size dt. The given state is not touched.
    StepAttempt advance(const Stage& stage, const State& state, double dt);

    const Ledger& ledger() const { return ledger_; }
    /// What steps take from now on is added up there; null: nowhere.
    void time_phases(PhaseTimes* times) { times_ = times; }

  private:
    /// Everything a step is computed from, once for all its iterations.
    struct Step;

    /// Computes the step once. Corrects the prediction where that turned out wrong.
    StepAttempt attempt_with(const Stage& stage, const State& state, double dt, Prediction& prediction);
    Prediction initial_prediction(const Stage& stage, const State& state, double dt) const;
    /// How far apart a corner and an edge may be and still meet within the step, m.
    double initial_search_radius(const Stage& stage, const State& state, double dt) const;
    /// m, that a corner may move by in a step.
    double displacement_limit(const StepControl& control) const {
        return control.displacement_ratio * half_height_;
    }
    Step prepare(const Stage& stage, const State& state, double dt, const Prediction& prediction);
    /// Whether springs are so stiff that rounding alone moves blocks' forces by much of their weight.
    bool is_too_stiff_for_rounding(const Step& step) const;
    /// Corners that got into another block in a step without a contact.
    std::vector<UndetectedPenetration> undetected_penetrations(const State& before, const State& after,
                                                               double reach) const;
    void assemble_base(const Stage& stage, const State& state, Step& step) const;
    /// Analyses the pattern of the contacts' candidates, if it is another one.
    void analyze_pattern(const ContactSet& contacts);
    OpenCloseResult solve(const Stage& stage, const State& state, const Step& step,
                          const InitialGuess& guess);
    std::vector<Vec6> all_displacements(const Step& step, const OpenCloseResult& result) const;
    double largest_displacement(const State& state, std::span<const Vec6> displacement) const;
    State updated_state(const Stage& stage, const State& state, const Step& step,
                        const OpenCloseResult& result, std::span<const Vec6> displacement) const;

    const Model& model_;
    ThreadPool pool_;
    RowMap rows_;
    Ledger ledger_;
    double half_height_ = 0;          ///< m, of the model
    double mean_weight_ = 0;          ///< N per metre, of a block
    double coordinate_rounding_ = 0;  ///< m, of a coordinate
    double edge_length_ = 0;          ///< m, median
    BlockPattern pattern_;
    std::vector<CornerEdge> pattern_candidates_;  ///< the candidates that it was made of
    BlockMatrix matrix_;
    RowContacts row_contacts_;
    std::unique_ptr<LinearSolver> solver_;
    PhaseTimes* times_ = nullptr;
};

}  // namespace rockslope::dda
