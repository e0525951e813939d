#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/linear/block_matrix.hpp"
#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// The matrix of a step's linear system, Eq. (3): inertia, elasticity and constraints (StepProblem::base),
/// plus the springs of the active contacts and of the elastic bolts. Only the rows of blocks whose springs
/// have changed are reassembled. Every entry is summed in the same order as in a full assembly, so both give
/// the same bits.
class StepMatrix {
  public:
    /// Stiffnesses of a contact's springs in the matrix, N/m per metre; 0 for a spring that is not active.
    struct Springs {
        double normal = 0;
        double shear = 0;
        double tilt = 0;  ///< of the normal spring, Eq. (83)
        friend bool operator==(const Springs&, const Springs&) = default;
    };

    /// @param work receives the matrix; the caller keeps its memory from step to step.
    StepMatrix(const StepProblem& problem, const BlockPattern& pattern, BlockMatrix& work,
               const ThreadPool& pool);

    /// Assembles the rows whose springs have changed, and all rows the first time.
    void assemble(const TrialContacts& trials);
    /// Assembles all rows with given springs of the contacts; the bolts are those of `trials`.
    /// @param springs per contact.
    void assemble(const TrialContacts& trials, const PerContact<Springs>& springs);
    /// The matrix of the last assembly.
    const BlockMatrix& matrix() const { return matrix_; }
    /// Per row, whether the last assembly changed it; empty after the first one, which assembles all rows.
    std::span<const char> changed() const { return changed_; }

  private:
    Springs springs_of(const TrialContacts& trials, ContactIndex contact) const;
    double stiffness_of_bolt(const TrialContacts& trials, std::size_t bolt) const;
    bool is_changed(RowIndex row) const { return row.exists() && (changed_.empty() || changed_[row] != 0); }
    /// Stores the present stiffnesses of contact springs and marks the rows of those that have changed.
    void update_springs(const TrialContacts& trials);
    void assemble_changed_rows();
    /// Does the same for bolts.
    void update_bolts(const TrialContacts& trials);
    /// Assembles the diagonal and upper blocks of a row, without bolts.
    void assemble_row(RowIndex row);
    void add_bolt(const BoltSpring& bolt, double stiffness);

    const StepProblem& p_;
    const BlockPattern& pattern_;
    BlockMatrix& matrix_;
    const ThreadPool& pool_;
    bool assembled_ = false;
    PerRow<char> changed_;              ///< per row
    PerContact<Springs> contacts_;      ///< per contact, stiffnesses in the matrix
    PerContact<char> contact_changed_;  ///< per contact, whether its stiffnesses have changed
    std::vector<double> bolts_;         ///< per bolt, stiffness in the matrix, N/m per metre
};

}  // namespace rockslope::dda
