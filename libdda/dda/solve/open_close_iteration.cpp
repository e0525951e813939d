#include "dda/solve/open_close_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dda/linear/anderson.hpp"
#include "dda/solve/iterate.hpp"
#include "dda/solve/methods/friction_coupling.hpp"
#include "dda/solve/methods/interior_point.hpp"
#include "dda/solve/methods/line_search.hpp"
#include "dda/solve/methods/patch_balance.hpp"
#include "dda/solve/outer/augmentation_rounds.hpp"
#include "dda/solve/outer/break_bonds.hpp"
#include "dda/solve/outer/dilation_rounds.hpp"
#include "dda/solve/outer/entrance_rounds.hpp"
#include "dda/solve/outer/gap_settling.hpp"
#include "dda/solve/step_matrix.hpp"
#include "dda/trial/step_contacts.hpp"

namespace rockslope::dda {

namespace {

/// Number of iterations in which the shear bounds are updated at every iterate. Then the interior-point
/// method takes over. Where it fails, the bounds are updated only at a minimum of the potential, as a
/// fixed-point iteration from minimum to minimum.
constexpr int bound_update_iterations = 16;
/// The interior-point method takes over earlier after so many short step lengths, which show that too many
/// contacts change their state at once.
constexpr int short_length_limit = 3;
constexpr double short_length = 0.1;
/// Number of damped steps in a row after which a dynamic step is accepted where the patches balance it, to
/// half the tolerance of forces. Otherwise the linear system balances it to rounding, and momentum is
/// conserved.
constexpr int stuck_after = 2;
/// Number of earlier minima that the Anderson mixing of the bounds uses.
constexpr int bound_memory = 6;

/// Relative residual of the linear solutions of the iteration, over the force tolerance. With a ratio of 10,
/// walls released from rest took 52 iterations a step instead of 11; with 0.1 as many as with
/// exact solutions. A shaken slope of 110 blocks needs less: 272 cut steps with 0.1, none with 0.001.
constexpr double residual_over_tolerance = 1e-3;
/// Largest relative residual of the linear solutions of the iteration.
constexpr double largest_iteration_residual = 1e-9;

/// Largest number of rounds of the interior-point method.
constexpr int interior_round_limit = 8;

class OpenCloseIteration {
  public:
    OpenCloseIteration(const StepProblem& problem, const BlockPattern& pattern, LinearSolver& solver,
                       IterationWorkspace& work, const ThreadPool& pool)
        : p_(problem),
          solver_(solver),
          matrix_(problem, pattern, work.matrix, pool),
          pool_(pool),
          times_(work.times),
          contacts_(problem, pool, std::move(work.trials)),
          entrances_(contacts_.entrances),
          dilation_(contacts_.dilation),
          augmentation_(problem, trials_),
          line_search_(problem, trials_, pool),
          friction_coupling_(problem, contacts_, solver, pool),
          patches_(problem, contacts_, work.patches, pool),
          fallbacks_before_(solver.fallbacks()),
          force_(problem.contacts.size()),
          iterate_(problem.rows.count()),
          iteration_residual_(std::clamp(residual_over_tolerance * problem.control.force_tolerance,
                                         full_tolerance, largest_iteration_residual)),
          bound_mixing_(bound_memory) {}

    OpenCloseResult run(Beginning beginning) {
        beginning_ = beginning;
        if (beginning == Beginning::in_one_patch) patches_.join_all();
        if (begins_at_found()) begin_at_found();
        bool matrix_changed = true;
        while (iterations_since_restart() < p_.control.iteration_limit) {
            if (matrix_changed && !factorize()) {
                is_astray_ = result_.iterations > 0 && is_in_patches();
                return std::move(result_);
            }
            ++result_.iterations;
            const bool bounds_follow = iterations_since_restart() <= bound_update_iterations;
            bounds_.hold_hardening(!bounds_follow);
            solve_linear_system(bounds_follow);
            end_of(Phase::solution, times_);
            const bool in_patches = is_in_patches();
            in_patches ? advance_in_patches() : advance_to_target();
            evaluate(in_patches);
            if (result_.gaps_unsettled || (!in_patches && !std::isfinite(result_.force_change))) break;
            // On the way to a minimum with held bounds the tilts are held, too.
            const bool holds = !in_patches && !bounds_follow && !is_at_minimum();
            if (in_patches)
                test_and_relax();
            else if (!holds)
                update_bounds_and_test(bounds_follow);
            if (result_.converged || result_.gaps_unsettled) break;
            if (is_astray()) return std::move(result_);
            using Tilts = TrialContacts::Tilts;
            matrix_changed = trials_.update_active_set(holds ? Tilts::held : Tilts::follow);
            if (is_stalled()) {
                if (solve_from_inside()) break;
                matrix_changed = true;
            }
            end_of(Phase::evaluation, times_);
            if (matrix_changed) augmentation_.forget();
        }
        is_astray_ = result_.gaps_unsettled && patches_.threw_a_block(iterate_.displacement());
        finish();
        end_of(Phase::evaluation, times_);
        return std::move(result_);
    }

    /// Whether the patches led away from the solution, or to a matrix that is not positive definite.
    bool went_astray() const { return is_astray_; }
    /// Per row: the displacement of the patches that was nearest to balance, m; empty if there is none.
    RowSpan<const Vec6> nearest() const { return patches_.nearest(); }
    /// The memory of the trials, for the next step.
    PerContact<ContactTrial> release_trials() { return trials_.release(); }

  private:
    /// Iterations since the start, or since dilation or augmentation last changed the problem.
    int iterations_since_restart() const { return result_.iterations - iterations_at_restart_; }
    bool is_in_patches() const {
        return beginning_ != Beginning::along_lines && iterations_since_restart() <= PatchBalance::iterations;
    }

    /// Whether the force change of a patch iteration shows that the patches lead astray.
    bool is_astray() {
        if (!is_in_patches()) return false;
        is_astray_ = patches_.leads_astray(iterations_since_restart(), result_.force_change);
        return is_astray_;
    }

    bool begins_at_found() const { return beginning_ != Beginning::along_lines && !p_.found.empty(); }

    /// Begins at the displacement of an earlier attempt, or at the nearest one of the patches that led
    /// astray. A first solution from the states alone would throw a block whose contacts all yield there.
    void begin_at_found() {
        iterate_.movable().assign(p_.found.begin(), p_.found.end());
        iterate_.stop_here();
        evaluate_exactly();
        contacts_.entrances.select_first();
        bounds_.update();
        if (relax_in_patches(0)) bounds_.update();
        trials_.update_active_set();
    }

    /// Assembles and factorises the matrix of the present active set. @return false if it is not positive
    /// definite.
    bool factorize() {
        matrix_.assemble(trials_);
        end_of(Phase::assembly, times_);
        ++result_.factorizations;
        const bool definite = solver_.refactorize(matrix_.matrix(), matrix_.changed());
        end_of(Phase::factorisation, times_);
        if (definite) return true;
        result_.singular = true;
        result_.fallbacks = solver_.fallbacks() - fallbacks_before_;
        return false;
    }

    /// Whether the active set does not settle. Only in static stages: in a step of a dynamic one few contacts
    /// change, and the iteration needs no more solutions. The lines of rough joint segments do not represent
    /// their laws well enough for the interior-point method.
    bool is_stalled() const {
        return p_.time.is_static() && !is_in_patches() && !interior_point_failed_ &&
               !bounds_.has_segments() &&
               (iterations_since_restart() >= bound_update_iterations || short_steps_ >= short_length_limit);
    }

    /// Solves by the interior-point method, in rounds: bonds that break, and bounds that were held, need
    /// another one. Where its path folds back, the bounds of all contacts are held for a round: that problem
    /// is convex. @return whether the result has converged.
    bool solve_from_inside() {
        InteriorPoint interior(p_, contacts_, matrix_, solver_, pool_, times_);
        PathStart start;
        bool failed = false;
        bool restarted = false;
        for (int round = 0; round < interior_round_limit && !failed && !restarted; ++round) {
            const InteriorPointResult found = interior.solve(iterate_.movable(), start);
            result_.iterations += found.iterations;
            result_.interior_iterations += found.iterations;
            result_.factorizations += found.iterations;
            substitutions_ += found.substitutions;
            iterate_.stop_here();
            evaluate_exactly();
            bounds_.update_all();
            if (!found.converged) {
                failed = start.hold_bounds || found.iterations == 0;
                start = {.hold_bounds = true};
                continue;
            }
            interior.set_linear_forces();
            const bool at_minimum = is_at_minimum();
            start = {.force_change = result_.force_change};
            if (!at_minimum || break_bonds(p_, trials_)) continue;
            accept_or_restart();
            if (result_.converged) return true;
            restarted = true;
        }
        interior_point_failed_ = !restarted;
        iterations_at_restart_ = result_.iterations;
        contacts_.entrances.select_first();
        bounds_.update();
        trials_.update_active_set();
        return false;
    }

    /// Updates entrance lines, dilation and shear bounds, and tests for convergence. Bounds that do not
    /// follow every iterate are mixed from one minimum of the potential to the next.
    void update_bounds_and_test(bool bounds_follow) {
        const Eigen::VectorXd previous_bounds = bounds_follow ? Eigen::VectorXd() : bounds_.values();
        follow_entrances();
        dilation_.follow(result_.iterations);
        bounds_.update();
        if (is_converged_exactly() && !break_bonds(p_, trials_))
            accept_or_restart();
        else if (!bounds_follow)
            bounds_.set_values(bound_mixing_.next(previous_bounds, bounds_.values()));
    }

    /// Along lines the first entrances follow every iterate, in patches as EntranceRounds has it.
    void follow_entrances() {
        if (beginning_ == Beginning::along_lines)
            contacts_.entrances.select_first();
        else
            entrances_.follow(iterations_since_restart(), [this] { return is_at_minimum(); });
    }

    /// Accepts a converged iterate, unless dilation or augmentation changes the problem: then restarts.
    void accept_or_restart() {
        if (!dilation_.update_at_minimum()) {
            result_.converged = !augmentation_.shift();
            if (result_.converged) return;
            dilation_.restart();
        }
        iterations_at_restart_ = result_.iterations;
        bound_mixing_ = AndersonMixing(bound_memory);
    }

    /// Sets the right-hand side: the load and the spring forces at zero unknowns, Eq. (24).
    /// RelativeMeasure::prescribed contains the displacement of blocks without unknowns.
    void set_right_hand_side() {
        pool_.parallel_for(force_.size(), [&](std::size_t begin, std::size_t end) {
            for (const ContactIndex k : indices<ContactIndex>(begin, end)) {
                const ContactSprings& s = p_.springs[k];
                const RelativeMeasure normal = trials_.normal_measure(k);
                const Forces forces = trials_.linear_forces(k, normal.prescribed, s.shear.prescribed);
                force_[k] = forces.normal * normal.direction - forces.shear * s.shear.direction;
            }
        });
        load_ = p_.base.load;
        pool_.parallel_for(load_.size(), [&](std::size_t begin, std::size_t end) {
            for (const RowIndex row : indices<RowIndex>(begin, end)) {
                for (const ContactIndex k : p_.row_contacts.of(row))
                    load_[row] += p_.springs[k].rows.project_on_row(row, force_[k]);
            }
        });
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            const BoltSpring& b = p_.bolts[k];
            b.rows.add_force(b.elongation, -trials_.bolts().linear_force(k, b.elongation.prescribed), load_);
        }
    }

    /// Solves the linear system. @param friction_follows whether the friction forces of sliding contacts are
    /// at the bounds of the solution's own normal forces, Eq. (35), or stay as they are.
    void solve_linear_system(bool friction_follows) {
        PerRow<Vec6>& target = iterate_.new_target();
        set_right_hand_side();
        substitutions_ += solver_.solve_coarsely(target, load_);
        const int substitutions = friction_follows ? friction_coupling_.solve(target) : 0;
        if (substitutions > 0) set_right_hand_side();
        substitutions_ += substitutions + solver_.refine(target, load_, iteration_residual_);
    }

    /// Moves the displacement towards the solution of the linear system by the step length of the line
    /// search; the first iteration takes the full step.
    void advance_to_target() {
        const bool is_first = result_.iterations == 1;
        const double step =
            is_first ? 1 : line_search_.step_length(iterate_.displacement(), iterate_.target());
        if (step < short_length) ++short_steps_;
        iterate_.advance(step);
    }
    /// Moves the displacement towards the solution of the linear system from blocks that were balanced in
    /// patches.
    void advance_in_patches() {
        if (iterations_since_restart() == 1 && !begins_at_found()) {
            damped_steps_ = 0;
            iterate_.advance(1);
            return;
        }
        iterate_.moved(patches_.advance(iterate_.target(), iterate_.movable()));
        damped_steps_ = iterate_.is_at_target() ? 0 : damped_steps_ + 1;
    }
    /// Evaluates the laws at the iterate. @param in_patches gaps follow the first iterates exactly; later
    /// they stay linear until the forces agree with the laws: a contact that hardly bears a force would open
    /// and close by the second-order part of its gap.
    void evaluate(bool in_patches) {
        using Gaps = TrialContacts::Gaps;
        const bool is_linear = in_patches && iterations_since_restart() > EntranceRounds::first_iterations;
        trials_.set_displacement(iterate_.displacement(), iterate_.target(),
                                 is_linear ? Gaps::linear : Gaps::exact);
        if (is_linear && is_at_minimum()) follow_gaps();
    }
    void evaluate_exactly() { trials_.set_displacement(iterate_.displacement(), iterate_.target()); }
    /// Evaluates the gaps exactly at a minimum for linear ones.
    void follow_gaps() {
        evaluate_exactly();
        test_gaps(trials_.force_change().largest);
    }
    /// Notes whether gaps do not settle. @param change N per metre, by which forces follow their exact
    /// values.
    void test_gaps(double change) {
        if (!gap_settling_.fails(change, trials_.tolerance())) return;
        result_.turns_otherwise = true;
        result_.gaps_unsettled = p_.may_predict_anew;
    }
    /// Tests for convergence where the step went all the way to the solution of the linear system, whose
    /// forces balance exactly. Otherwise balances the blocks whose forces do not, in patches, tests again if
    /// that was all, and updates the dilation from there.
    void test_and_relax() {
        follow_entrances();
        // Without dilation the force change is found by the test below, if the iterate is at the target.
        const bool seeks_minimum = contacts_.dilation.any() || !iterate_.is_at_target();
        if (DilationRounds::follows(result_.iterations) && seeks_minimum && is_at_minimum())
            contacts_.dilation.update();
        bounds_.update();
        if (iterate_.is_at_target() && is_converged_exactly() && !break_bonds(p_, trials_)) {
            accept_or_restart();
            return;
        }
        relax_in_patches(iterations_since_restart());
        if (accepts_patches() && patches_.is_complete(iterate_.displacement()) && agrees_with_patches() &&
            !break_bonds(p_, trials_)) {
            accept_or_restart();
            return;
        }
        dilation_.follow(result_.iterations);
        bounds_.update();
    }
    /// Balances blocks in patches. @param iteration of the step, as PatchBalance counts. @return whether any.
    bool relax_in_patches(int iteration) {
        if (!patches_.relax(iteration, iterate_.movable())) return false;
        iterate_.moved(false);
        trials_.move_to(iterate_.displacement());
        return true;
    }
    /// Whether the balance that patches find suffices: in a static step, and where the solution of the linear
    /// system throws blocks again and again.
    bool accepts_patches() const { return p_.time.is_static() || damped_steps_ >= stuck_after; }
    /// Whether the laws at the iterate agree with the forces by which the patches balanced all blocks.
    bool agrees_with_patches() {
        iterate_.stop_here();
        trials_.measure_gaps(iterate_.displacement());
        follow_entrances();
        bounds_.update_all();
        if (is_at_minimum()) return true;
        test_gaps(result_.force_change);
        return false;
    }
    /// Whether the displacement is a minimum of the potential with the present bounds, Eq. (36): the forces
    /// of the laws agree with those of the linear system, which balance, and so little displacement remains
    /// that its inertia and strain forces are below the tolerance, too.
    bool is_at_minimum() {
        const TrialContacts::ForceChange change = trials_.force_change();
        if (change.contact.exists()) result_.worst_contact = change.contact;
        result_.force_change = change.largest;
        return std::isfinite(change.largest) && change.largest <= trials_.tolerance() &&
               (iterate_.is_at_target() || iterate_.remaining_force(p_, pool_) <= trials_.tolerance());
    }

    /// Whether the iterate is at the minimum also after the linear system is solved to full accuracy and the
    /// bounds of all joint laws are evaluated again.
    bool is_converged_exactly() {
        if (!is_at_minimum()) return false;
        end_of(Phase::evaluation, times_);
        const int substitutions = solver_.refine(iterate_.refined_target(), load_, full_tolerance);
        end_of(Phase::solution, times_);
        substitutions_ += substitutions;
        if (substitutions > 0) {
            iterate_.follow_target();
            evaluate_exactly();
            follow_entrances();
        } else if (!bounds_.has_segments()) {
            return true;
        }
        bounds_.update_all();
        return is_at_minimum();
    }

    void finish() {
        result_.substitutions = substitutions_;
        result_.fallbacks = solver_.fallbacks() - fallbacks_before_;
        result_.displacement.assign(iterate_.displacement().begin(), iterate_.displacement().end());
        result_.contacts.resize(trials_.count());
        trials_.evaluate(result_.contacts);
        for (std::size_t k = 0; k < p_.bolts.size(); ++k)
            result_.bolt_force.push_back(trials_.bolts().force(k));
    }

    const StepProblem& p_;
    LinearSolver& solver_;
    StepMatrix matrix_;
    const ThreadPool& pool_;
    PhaseTimes* times_;
    Beginning beginning_ = Beginning::in_patches;
    StepContacts contacts_;
    TrialContacts& trials_ = contacts_.trials;
    ShearBounds& bounds_ = contacts_.bounds;
    EntranceRounds entrances_;
    DilationRounds dilation_;
    AugmentationRounds augmentation_;
    LineSearch line_search_;
    FrictionCoupling friction_coupling_;
    PatchBalance patches_;
    int fallbacks_before_;
    PerContact<Vec2> force_;  ///< per contact, on the corner's block, N per metre
    PerRow<Vec6> load_;       ///< per row: right-hand side
    Iterate iterate_;
    int damped_steps_ = 0;  ///< in a row, from patches
    bool is_astray_ = false;
    GapSettling gap_settling_;
    double iteration_residual_;  ///< residual of linear solutions over the load
    int substitutions_ = 0;
    int iterations_at_restart_ = 0;
    int short_steps_ = 0;  ///< step lengths below short_length
    bool interior_point_failed_ = false;
    AndersonMixing bound_mixing_;
    OpenCloseResult result_;
};

}  // namespace

IterationOutcome iterate_open_close(const StepProblem& problem, Beginning beginning,
                                    const BlockPattern& pattern, LinearSolver& solver,
                                    IterationWorkspace& work, const ThreadPool& pool) {
    OpenCloseIteration iteration(problem, pattern, solver, work, pool);
    IterationOutcome outcome;
    outcome.result = iteration.run(beginning);
    outcome.went_astray = iteration.went_astray();
    if (outcome.went_astray) outcome.nearest.assign(iteration.nearest().begin(), iteration.nearest().end());
    work.trials = iteration.release_trials();
    return outcome;
}

}  // namespace rockslope::dda
