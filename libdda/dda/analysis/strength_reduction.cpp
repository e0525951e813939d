#include "dda/analysis/strength_reduction.hpp"

#include <algorithm>
#include <cmath>

#include "dda/analysis/run_stage.hpp"

namespace rockslope::dda {

namespace {

double largest_centroid_displacement(const State& from, const State& to) {
    double largest = 0;
    for (std::size_t b = 0; b < from.blocks.moments.size(); ++b) {
        largest = std::max(largest, (to.blocks.moments[b].centroid - from.blocks.moments[b].centroid).norm());
    }
    return largest;
}

/// Ends a trial when the run's observer stops it.
class TrialObserver : public RunObserver {
  public:
    TrialObserver(const State& start, RunObserver& observer) : start_(start), observer_(observer) {}

    bool step_done(const Model& model, const State& state, const Stage& stage,
                   const StepReport& report) override {
        unbalanced_force = report.unbalanced_force;
        displacement = largest_centroid_displacement(start_, state);
        stopped = !observer_.trial_step_done(model, state, stage, report);
        return !stopped;
    }

    double unbalanced_force = 0;
    double displacement = 0;
    bool stopped = false;

  private:
    const State& start_;
    RunObserver& observer_;
};

/// Reduces the shear forces of joint segments to their reduced strengths. A law that lets its force lag
/// behind a strength that falls as the joint wears would let it lag behind one that falls by the factor, too,
/// and joints would bear more than they have.
void reduce_to_strength(const Model& weakened, State& state) {
    for (Contact& contact : state.contacts.contacts) {
        const JointLaw& law = weakened.joint_material_at(contact.joint_material).law;
        if (!has_segment_history(law) || !(contact.normal_force > 0)) continue;
        const Strength whole = strength(law, *contact.history, contact.normal_force, contact.length);
        const double reduced = 1 / weakened.strength_reduction;
        contact.shear_force =
            std::clamp(contact.shear_force, -reduced * whole.backward, reduced * whole.forward);
    }
}

class FactorSearch {
  public:
    FactorSearch(const Model& model, const Stage& stage, const State& start, RunObserver& observer,
                 int threads)
        : model_(model),
          stage_(stage),
          spec_(*stage.strength_reduction),
          start_(start),
          observer_(observer),
          threads_(threads),
          clock_(start.time) {
        stage_.displacement_limit = spec_.displacement_limit;
    }

    /// @return false if the observer stopped it.
    bool run() {
        for (double factor = 1;;) {
            if (!try_factor(factor)) return false;
            if (stands_ && fails_) break;
            const double next =
                stands_ ? std::min(2 * *stands_, spec_.highest) : std::max(*fails_ / 2, spec_.lowest);
            if (next == factor) return true;  // nothing changes up to the bound
            factor = next;
        }
        while (*fails_ / *stands_ > 1 + spec_.width) {
            if (!try_factor(std::sqrt(*stands_ * *fails_))) return false;
        }
        return true;
    }

    double clock() const { return clock_; }
    /// The final state of the failed trial with the smallest factor, if any failed.
    const std::optional<State>& mechanism() const { return mechanism_; }

  private:
    bool try_factor(double factor) {
        Model weakened = model_;
        weakened.strength_reduction *= factor;
        TimeStepper stepper(weakened, threads_);
        State state = start_;
        state.time = clock_;
        begin_stage(state);
        reduce_to_strength(weakened, state);
        TrialObserver trial_observer(start_, observer_);
        const RunOutcome outcome = run_stage(weakened, stage_, stepper, state, trial_observer);
        if (trial_observer.stopped) return false;
        clock_ = state.time;
        const bool stands = outcome.status == RunStatus::completed;
        (stands ? stands_ : fails_) = factor;
        observer_.trial_done(model_, state, stage_,
                             {factor, stands, state.stage_steps, trial_observer.unbalanced_force,
                              trial_observer.displacement});
        if (!stands) mechanism_ = std::move(state);
        return true;
    }

    const Model& model_;
    Stage stage_;  ///< of a trial
    const StrengthReduction spec_;
    const State& start_;
    RunObserver& observer_;
    int threads_;
    double clock_;
    std::optional<double> stands_;  ///< the largest factor that stands
    std::optional<double> fails_;   ///< the smallest that fails
    std::optional<State> mechanism_;
};

}  // namespace

RunOutcome find_factor_of_safety(const Model& model, const Stage& stage, State& state, RunObserver& observer,
                                 int threads) {
    FactorSearch search(model, stage, state, observer, threads);
    if (!search.run()) return {RunStatus::stopped, "stopped as asked", {}};
    if (search.mechanism()) observer.mechanism_found(model, *search.mechanism(), stage);
    state.time = search.clock();
    return {};
}

}  // namespace rockslope::dda
