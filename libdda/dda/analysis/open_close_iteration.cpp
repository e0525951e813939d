#include "dda/analysis/open_close_iteration.hpp"

#include <algorithm>
#include <cmath>

#include "dda/analysis/friction_coupling.hpp"
#include "dda/analysis/line_search.hpp"
#include "dda/analysis/step_matrix.hpp"
#include "dda/analysis/trial_contacts.hpp"
#include "dda/linear/anderson.hpp"

namespace rockslope::dda {

namespace {

/// Iterations in which the shear bounds follow every iterate; past these they wait for the minimum of the
/// potential, and from one minimum to the next they are a fixed point to be found.
constexpr int bound_update_iterations = 16;
/// Earlier minima remembered in the search for that fixed point.
constexpr int bound_memory = 6;

/// Iterations in which the dilation follows every iterate, and minima of the potential at which it is brought
/// to where they are. It depends on the displacement and on the normal force that it brings about itself: of
/// many joints it may not settle within a step, and what is left then acts from the next one on.
constexpr int dilation_iterations = 8;
constexpr int dilation_minima = 2;

/// Augmentations of the contact forces in a step; what is left of the penetration then is for the next step.
constexpr int largest_augmentations = 60;
constexpr int augmentation_memory = 10;

/// Of the force tolerance and of the load, what solutions that are evaluated leave in the residual: what is
/// left moves forces by little beside the tolerance. With ten times the tolerance walls let go, which take 11
/// iterations a step, took 52; with a tenth of it, or less, as many as with exact solutions.
constexpr double residual_share = 0.1;
constexpr double largest_iteration_residual = 1e-7;

class Iteration {
  public:
    Iteration(const StepProblem& problem, const BlockPattern& pattern, LinearSolver& solver,
              BlockMatrix& work, const ThreadPool& pool, PhaseTimes* times)
        : p_(problem),
          solver_(solver),
          matrix_(problem, pattern, work, pool),
          pool_(pool),
          times_(times),
          trials_(problem, pool),
          line_search_(problem, trials_, pool),
          friction_coupling_(problem, trials_, solver, pool),
          fallbacks_before_(solver.fallbacks()),
          force_(problem.contacts.size()),
          iteration_residual_(std::clamp(residual_share * problem.control.force_tolerance, full_tolerance,
                                         largest_iteration_residual)) {
        displacement_.assign(static_cast<std::size_t>(p_.rows.count()), Vec6::Zero());
    }

    OpenCloseResult run() {
        OpenCloseResult result;
        bool changed = true;
        int iterations_before = 0;  // the iterations before springs were last given another rest
        int augmentations = 0;
        int minima = 0;  // since the last of them
        AndersonMixing augmentation_mixing(augmentation_memory);
        AndersonMixing bound_mixing(bound_memory);
        while (result.iterations - iterations_before < p_.control.iteration_limit) {
            if (changed) {
                matrix_.assemble(trials_);
                end_of(Phase::assembly, times_);
                ++result.factorizations;
                const bool definite = solver_.refactorize(matrix_.matrix(), matrix_.changed());
                end_of(Phase::factorisation, times_);
                if (!definite) {
                    result.singular = true;
                    result.fallbacks = solver_.fallbacks() - fallbacks_before_;
                    return result;
                }
            }
            ++result.iterations;
            const bool follow = result.iterations - iterations_before <= bound_update_iterations;
            follow ? solve_with_coupled_friction() : solve_with_fixed_friction();
            end_of(Phase::solution, times_);
            advance_to_target(result.iterations == 1);

            trials_.set_displacement(displacement_, target_);
            if (follow || is_at_minimum(result)) {
                const Eigen::VectorXd previous_bounds = follow ? Eigen::VectorXd() : trials_.shear_bounds();
                trials_.select_first_entrances();
                if (result.iterations <= dilation_iterations) trials_.update_dilation();
                trials_.update_bounds();
                if (is_settled_exactly(result) && !trials_.break_bonds()) {
                    if (!update_dilation_at(++minima)) {
                        result.converged =
                            augmentations == largest_augmentations || !trials_.augment(augmentation_mixing);
                        if (result.converged) break;
                        ++augmentations;
                        minima = 0;
                    }
                    iterations_before = result.iterations;
                    bound_mixing = AndersonMixing(bound_memory);
                } else if (!follow) {
                    trials_.set_shear_bounds(bound_mixing.next(previous_bounds, trials_.shear_bounds()));
                }
            }
            changed = trials_.update_active_set();
            end_of(Phase::evaluation, times_);
            if (changed) augmentation_mixing = AndersonMixing(augmentation_memory);
        }
        finish(result);
        end_of(Phase::evaluation, times_);
        return result;
    }

  private:
    /// The load, and the springs' forces at zero unknowns: the known displacement of blocks without unknowns
    /// is in RelativeMeasure::prescribed.
    void set_right_hand_side() {
        pool_.parallel_for(force_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const ContactSprings& s = p_.springs[k];
                const Forces forces = trials_.linear_forces(k, s.normal.prescribed, s.shear.prescribed);
                force_[k] = forces.normal * s.normal.direction - forces.shear * s.shear.direction;
            }
        });
        load_ = p_.base.load;
        pool_.parallel_for(load_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                for (const int contact : p_.row_contacts.of(row)) {
                    const auto k = static_cast<std::size_t>(contact);
                    load_[row] += p_.springs[k].rows.project_on_row(static_cast<int>(row), force_[k]);
                }
            }
        });
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            const BoltSpring& b = p_.bolts[k];
            b.rows.add_force(b.elongation, -trials_.linear_bolt_force(k, b.elongation.prescribed), load_);
        }
    }

    /// Solves the linear system with the shear forces of sliding contacts as they are held.
    void solve_with_fixed_friction() {
        target_ = displacement_;
        set_right_hand_side();
        substitutions_ += solver_.solve_coarsely(target_, load_);
        substitutions_ += solver_.refine(target_, load_, iteration_residual_);
    }

    /// Likewise, with these at the bounds that belong to the solution's own normal forces.
    void solve_with_coupled_friction() {
        target_ = displacement_;
        set_right_hand_side();
        substitutions_ += solver_.solve_coarsely(target_, load_);
        const int substitutions = friction_coupling_.solve(target_);
        if (substitutions > 0) set_right_hand_side();
        substitutions_ += substitutions + solver_.refine(target_, load_, iteration_residual_);
    }

    /// Goes from the present displacement towards the linear system's solution, as far as the potential
    /// falls.
    void advance_to_target(bool first) {
        const double left = first ? 0 : 1 - line_search_.step_length(displacement_, target_);
        remaining_displacement_.resize(target_.size());
        for (std::size_t r = 0; r < target_.size(); ++r)
            remaining_displacement_[r] = left * (target_[r] - displacement_[r]);
        is_at_target_ = left == 0;
        apply_step_length();
    }
    void apply_step_length() {
        displacement_ = target_;
        if (is_at_target_) return;
        for (std::size_t r = 0; r < target_.size(); ++r) displacement_[r] -= remaining_displacement_[r];
    }

    /// Whether the forces under which the blocks are in balance are what the laws with the present bounds
    /// say, and what takes a block's inertia and strain on to that balance is as little.
    bool is_at_minimum(OpenCloseResult& result) {
        const TrialContacts::ForceChange change = trials_.force_change();
        if (change.contact >= 0) result.worst_contact = change.contact;
        result.force_change = change.largest;
        return change.largest <= trials_.tolerance() &&
               (is_at_target_ || remaining_force() <= trials_.tolerance());
    }

    /// The largest force on a block, N per metre, that the way to the linear system's solution takes besides
    /// the springs': moments and what strains it over the root of its area.
    double remaining_force() const {
        const auto of_rows = [&](std::size_t begin, std::size_t end) {
            double largest = 0;
            for (std::size_t r = begin; r < end; ++r) {
                Vec6 force = p_.base.stiffness[r] * remaining_displacement_[r];
                const auto block = static_cast<std::size_t>(p_.rows.block_of[r]);
                force.tail<4>() /= std::sqrt(p_.blocks.moments[block].area);
                largest = std::max(largest, force.cwiseAbs().maxCoeff());
            }
            return largest;
        };
        return pool_.parallel_reduce(remaining_displacement_.size(), 0.0, of_rows,
                                     [](double a, double b) { return std::max(a, b); });
    }

    /// Whether an iterate at the minimum is so still when the linear system is solved exactly and all laws
    /// are asked for their bounds.
    bool is_settled_exactly(OpenCloseResult& result) {
        if (!is_at_minimum(result)) return false;
        end_of(Phase::evaluation, times_);
        const int taken = solver_.refine(target_, load_, full_tolerance);
        end_of(Phase::solution, times_);
        substitutions_ += taken;
        if (taken > 0) {
            apply_step_length();
            trials_.set_displacement(displacement_, target_);
            trials_.select_first_entrances();
        } else if (!trials_.has_segments()) {
            return true;
        }
        trials_.update_all_bounds();
        return is_at_minimum(result);
    }

    /// Brings the dilation to where a minimum of the potential is. @return whether that moves anything.
    bool update_dilation_at(int minimum) {
        if (minimum > dilation_minima) return trials_.postpone_dilation();
        if (!trials_.dilation_exceeds_tolerance()) return false;
        trials_.update_dilation();
        return true;
    }

    void finish(OpenCloseResult& result) const {
        result.substitutions = substitutions_;
        result.fallbacks = solver_.fallbacks() - fallbacks_before_;
        result.displacement = displacement_;
        result.contacts.resize(trials_.count());
        trials_.evaluate(result.contacts);
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) result.bolt_force.push_back(trials_.bolt_force(k));
    }

    const StepProblem& p_;
    LinearSolver& solver_;
    StepMatrix matrix_;
    const ThreadPool& pool_;
    PhaseTimes* times_;
    TrialContacts trials_;
    LineSearch line_search_;
    FrictionCoupling friction_coupling_;
    int fallbacks_before_;
    std::vector<Vec2> force_;                   ///< per contact, on the first block's point, N per metre
    std::vector<Vec6> load_;                    ///< per row: right-hand side
    std::vector<Vec6> target_;                  ///< per row: the linear system's solution, m
    std::vector<Vec6> displacement_;            ///< likewise: where the iteration is, m
    std::vector<Vec6> remaining_displacement_;  ///< likewise: from there to that solution, m
    bool is_at_target_ = true;                  ///< there is no way left
    double iteration_residual_;                 ///< share of the load
    int substitutions_ = 0;
};

}  // namespace

OpenCloseResult iterate_open_close(const StepProblem& problem, const BlockPattern& pattern,
                                   LinearSolver& solver, BlockMatrix& work, const ThreadPool& pool,
                                   PhaseTimes* times) {
    return Iteration(problem, pattern, solver, work, pool, times).run();
}

}  // namespace rockslope::dda
