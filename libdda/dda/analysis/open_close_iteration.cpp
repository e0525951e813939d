#include "dda/analysis/open_close_iteration.hpp"

#include <algorithm>
#include <cmath>

#include "dda/analysis/held_friction.hpp"
#include "dda/analysis/line_search.hpp"
#include "dda/analysis/step_matrix.hpp"
#include "dda/analysis/trial_contacts.hpp"
#include "dda/linear/anderson.hpp"

namespace dda {

namespace {

/// Iterations in which the shear bounds follow every iterate; past these they wait for the minimum of the
/// potential, and from one minimum to the next they are a fixed point to be found.
constexpr int following_iterations = 16;
/// Earlier minima remembered in the search for that fixed point.
constexpr int friction_memory = 6;

/// Iterations in which the dilation follows every iterate, and minima of the potential at which it is brought
/// to where they are. It depends on the displacement and on the normal force that it brings about itself: of
/// many joints it may not settle within a step, and what is left then acts from the next one on.
constexpr int dilation_iterations = 8;
constexpr int dilation_minima = 2;

/// Augmentations of the contact forces in a step; what is left of the penetration then is for the next step.
constexpr int largest_augmentations = 60;
constexpr int augmentation_memory = 10;

/// Of the force tolerance and of the load, what solutions that are judged leave in the residual: what is left
/// moves forces by little beside the tolerance. With ten times the tolerance walls let go, which take 11
/// iterations a step, took 52; with a tenth of it, or less, as many as with exact solutions.
constexpr double judged_share = 0.1;
constexpr double largest_judged_residual = 1e-7;

class Iteration {
  public:
    Iteration(const StepProblem& problem, const BlockPattern& pattern, LinearSolver& solver,
              BlockMatrix& work, const Crew& crew, PhaseTimes* times)
        : p_(problem),
          solver_(solver),
          matrix_(problem, pattern, work, crew),
          crew_(crew),
          times_(times),
          trials_(problem, crew),
          line_search_(problem, trials_, crew),
          friction_(problem, trials_, solver, crew),
          fallbacks_before_(solver.fallbacks()),
          force_(problem.contacts.size()),
          judged_residual_(std::clamp(judged_share * problem.control.force_tolerance, exact_residual,
                                      largest_judged_residual)) {
        displacement_.assign(static_cast<std::size_t>(p_.rows.count()), Vec6::Zero());
    }

    OpenCloseResult run() {
        OpenCloseResult result;
        bool changed = true;
        int began = 0;  // the iterations before springs were last given another rest
        int augmentations = 0;
        int minima = 0;  // since the last of them
        AndersonMixing shifting(augmentation_memory);
        AndersonMixing mixing(friction_memory);
        while (result.iterations - began < p_.control.iteration_limit) {
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
            const bool follow = result.iterations - began <= following_iterations;
            follow ? solve_with_friction() : solve_as_held();
            end_of(Phase::solution, times_);
            advance_to_target(result.iterations == 1);

            trials_.move_to(displacement_, target_);
            if (follow || is_at_minimum(result)) {
                const Eigen::VectorXd held = follow ? Eigen::VectorXd() : trials_.coupling();
                trials_.choose_lines();
                if (result.iterations <= dilation_iterations) trials_.update_dilation();
                trials_.update_bounds();
                if (is_settled(result) && !trials_.tear()) {
                    if (!dilate_at(++minima)) {
                        result.converged =
                            augmentations == largest_augmentations || !trials_.augment(shifting);
                        if (result.converged) break;
                        ++augmentations;
                        minima = 0;
                    }
                    began = result.iterations;
                    mixing = AndersonMixing(friction_memory);
                } else if (!follow) {
                    trials_.set_coupling(mixing.next(held, trials_.coupling()));
                }
            }
            changed = trials_.choose_springs();
            end_of(Phase::judging, times_);
            if (changed) shifting = AndersonMixing(augmentation_memory);
        }
        finish(result);
        end_of(Phase::judging, times_);
        return result;
    }

  private:
    /// The load, and the springs' forces at zero unknowns: the known displacement of blocks without unknowns
    /// is in Relative::known.
    void set_right_hand_side() {
        crew_.for_ranges(force_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const ContactSprings& s = p_.springs[k];
                const Forces forces = trials_.linear_forces(k, s.normal.known, s.shear.known);
                force_[k] = forces.normal * s.normal.direction - forces.shear * s.shear.direction;
            }
        });
        load_ = p_.base.load;
        crew_.for_ranges(load_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                for (const int contact : p_.row_contacts.of(row)) {
                    const auto k = static_cast<std::size_t>(contact);
                    load_[row] += p_.springs[k].rows.of_row(static_cast<int>(row), force_[k]);
                }
            }
        });
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) {
            const BoltSpring& b = p_.bolts[k];
            b.rows.add_force(b.elongation, -trials_.linear_bolt_force(k, b.elongation.known), load_);
        }
    }

    /// Solves the linear system with the shear forces of sliding contacts as they are held.
    void solve_as_held() {
        target_ = displacement_;
        set_right_hand_side();
        substitutions_ += solver_.approach(target_, load_);
        substitutions_ += solver_.refine(target_, load_, judged_residual_);
    }

    /// Likewise, with these at the bounds that belong to the solution's own normal forces.
    void solve_with_friction() {
        target_ = displacement_;
        set_right_hand_side();
        substitutions_ += solver_.approach(target_, load_);
        const int changes = friction_.agree(target_);
        if (changes > 0) set_right_hand_side();
        substitutions_ += changes + solver_.refine(target_, load_, judged_residual_);
    }

    /// Goes from the present displacement towards the linear system's solution, as far as the potential
    /// falls.
    void advance_to_target(bool first) {
        const double left = first ? 0 : 1 - line_search_.share(displacement_, target_);
        way_left_.resize(target_.size());
        for (std::size_t r = 0; r < target_.size(); ++r)
            way_left_[r] = left * (target_[r] - displacement_[r]);
        is_at_target_ = left == 0;
        stop_short_of_target();
    }
    void stop_short_of_target() {
        displacement_ = target_;
        if (is_at_target_) return;
        for (std::size_t r = 0; r < target_.size(); ++r) displacement_[r] -= way_left_[r];
    }

    /// Whether the forces under which the blocks are in balance are what the laws with the present bounds
    /// say, and what takes a block's inertia and strain on to that balance is as little.
    bool is_at_minimum(OpenCloseResult& result) {
        const TrialContacts::ForceChange change = trials_.force_change();
        if (change.contact >= 0) result.worst_contact = change.contact;
        result.force_change = change.largest;
        return change.largest <= trials_.tolerance() &&
               (is_at_target_ || force_left() <= trials_.tolerance());
    }

    /// The largest force on a block, N per metre, that the way to the linear system's solution takes besides
    /// the springs': moments and what strains it over the root of its area.
    double force_left() const {
        const auto of_rows = [&](std::size_t begin, std::size_t end) {
            double largest = 0;
            for (std::size_t r = begin; r < end; ++r) {
                Vec6 force = p_.base.stiffness[r] * way_left_[r];
                const auto block = static_cast<std::size_t>(p_.rows.block_of[r]);
                force.tail<4>() /= std::sqrt(p_.blocks.moments[block].area);
                largest = std::max(largest, force.cwiseAbs().maxCoeff());
            }
            return largest;
        };
        return crew_.taken_together(way_left_.size(), 0.0, of_rows,
                                    [](double a, double b) { return std::max(a, b); });
    }

    /// Whether an iterate at the minimum is so still when the linear system is solved exactly and all laws
    /// are asked for their bounds.
    bool is_settled(OpenCloseResult& result) {
        if (!is_at_minimum(result)) return false;
        end_of(Phase::judging, times_);
        const int taken = solver_.refine(target_, load_, exact_residual);
        end_of(Phase::solution, times_);
        substitutions_ += taken;
        if (taken > 0) {
            stop_short_of_target();
            trials_.move_to(displacement_, target_);
            trials_.choose_lines();
        } else if (!trials_.has_faces()) {
            return true;
        }
        trials_.settle_bounds();
        return is_at_minimum(result);
    }

    /// Brings the dilation to where a minimum of the potential is. @return whether that moves anything.
    bool dilate_at(int minimum) {
        if (minimum > dilation_minima) return trials_.postpone_dilation();
        if (!trials_.dilation_is_off()) return false;
        trials_.update_dilation();
        return true;
    }

    void finish(OpenCloseResult& result) const {
        result.substitutions = substitutions_;
        result.fallbacks = solver_.fallbacks() - fallbacks_before_;
        result.displacement = displacement_;
        result.contacts.resize(trials_.count());
        trials_.judge(result.contacts);
        for (std::size_t k = 0; k < p_.bolts.size(); ++k) result.bolt_force.push_back(trials_.bolt_force(k));
    }

    const StepProblem& p_;
    LinearSolver& solver_;
    StepMatrix matrix_;
    const Crew& crew_;
    PhaseTimes* times_;
    TrialContacts trials_;
    LineSearch line_search_;
    HeldFriction friction_;
    int fallbacks_before_;
    std::vector<Vec2> force_;         ///< per contact, on the first block's point, N per metre
    std::vector<Vec6> load_;          ///< per row: right-hand side
    std::vector<Vec6> target_;        ///< per row: the linear system's solution, m
    std::vector<Vec6> displacement_;  ///< likewise: where the iteration is, m
    std::vector<Vec6> way_left_;      ///< likewise: from there to that solution, m
    bool is_at_target_ = true;        ///< there is no way left
    double judged_residual_;          ///< share of the load
    int substitutions_ = 0;
};

}  // namespace

OpenCloseResult iterate_open_close(const StepProblem& problem, const BlockPattern& pattern,
                                   LinearSolver& solver, BlockMatrix& work, const Crew& crew,
                                   PhaseTimes* times) {
    return Iteration(problem, pattern, solver, work, crew, times).run();
}

}  // namespace dda
