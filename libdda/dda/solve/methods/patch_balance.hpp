#pragma once

#include <limits>

#include "dda/path/damped_step.hpp"
#include "dda/path/patches.hpp"
#include "dda/solve/methods/balance_progress.hpp"
#include "dda/trial/step_contacts.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// Balances the blocks of a step in patches, from iteration to iteration: which blocks, how wide the patches
/// are, how long their paths may be, and whether they lead anywhere (theory sec. 22).
class PatchBalance {
  public:
    /// Number of iterations of a step that balance blocks in patches.
    static constexpr int iterations = 24;

    /// Memory that is kept from step to step.
    struct Memory {
        Patches patches;
        DampedStep damped_step;
        LimitedForces forces;
        PerRow<Vec6> before;                  ///< displacement, m, that is balanced
        PerContact<LimitedContact> contacts;  ///< and bolts
        RowContacts row_contacts;             ///< of them, where there are bolts
    };

    /// For a step, from its first iteration on.
    PatchBalance(const StepProblem& problem, StepContacts& contacts, Memory& memory, const ThreadPool& pool);

    /// Whether the step may be solved in one patch of all blocks. Each border on its path takes a time that
    /// grows with the number of blocks: 1.2 ms for 992.
    static bool suits_one_patch(const StepProblem& problem);
    /// Makes all blocks one patch: its path is exact, and no far field is left.
    void join_all();

    /// Moves blocks that were balanced towards the solution of the linear system, Eq. (101).
    /// @param displacement per row, m. @return whether it is the target now.
    bool advance(RowSpan<const Vec6> target, PerRow<Vec6>& displacement);
    /// Balances the blocks whose forces do not obey the laws, as these are at the displacement.
    /// @param iteration of the step, from 1; 0: before the first, at the displacement of an earlier attempt.
    /// @return whether any block was balanced.
    bool relax(int iteration, RowSpan<Vec6> displacement);
    /// Whether all blocks are balanced under the laws that the patches last saw. Then the forces of the
    /// linear system are set to those of these laws.
    bool is_complete(RowSpan<const Vec6> displacement);
    /// Per row: of the displacements that the patches were given, that with the least unbalanced force, m.
    /// One patch begins there. Empty where the step does not suit one.
    RowSpan<const Vec6> nearest() const { return nearest_; }
    /// Whether a block is farther than one may go in a step: linear gaps may balance it anywhere.
    bool threw_a_block(RowSpan<const Vec6> displacement) const;
    /// Whether the patches lead away from the solution, or take too long.
    /// @param force_change N per metre, the largest of the iteration.
    bool leads_astray(int iteration, double force_change);

  private:
    /// The step as the patches last saw it.
    LimitedStep limited_step() const {
        return {p_.base, p_.bolts.empty() ? p_.row_contacts : memory_.row_contacts, memory_.contacts};
    }
    PatchExtent next_extent() const;
    PathStarts starts_in(int iteration) const;
    int border_limit() const;
    void find_contacts_and_bolts();
    void set_linear_forces();

    const StepProblem& p_;
    TrialContacts& trials_;
    const ShearBounds& bounds_;
    Memory& memory_;
    const ThreadPool& pool_;
    PerRow<double> length_;  ///< per row: square root of the block's area, m
    bool is_one_patch_ = false;
    bool began_balanced_ = false;     ///< by an earlier attempt
    bool exact_path_failed_ = false;  ///< in the last iteration
    BalanceProgress progress_;
    PerRow<Vec6> nearest_;
    double least_unbalanced_ = std::numeric_limits<double>::infinity();  ///< N per metre, there
    double visits_left_;             ///< of contacts, that the patches may still make in search of borders
    double first_force_change_ = 0;  ///< N per metre, of the step's first iteration; or of two, where the
                                     ///< first begins balanced and hardly changes a force
};

}  // namespace rockslope::dda
