#pragma once

#include <span>
#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/trial_contacts.hpp"
#include "dda/linear/block_matrix.hpp"

namespace rockslope::dda {

/// The matrix of a step's linear system: what does not depend on contacts, and the springs that the contacts
/// and bolts have at present. Of an iteration in which few of them change only the rows of their blocks are
/// put together anew; each entry is the same sum in the same order as in a matrix made at once.
class StepMatrix {
  public:
    /// @param work the matrix itself, whose memory outlives the step.
    StepMatrix(const StepProblem& problem, const BlockPattern& pattern, BlockMatrix& work,
               const ThreadPool& pool);

    /// Brings the matrix to the springs' present states.
    void assemble(const TrialContacts& trials);
    const BlockMatrix& matrix() const { return matrix_; }
    /// Per row, whether the last assembly put it together; empty where that was the first, of all of them.
    std::span<const char> changed() const { return changed_; }

  private:
    /// Stiffnesses of a contact's springs in the matrix, N/m per metre; 0 for one that is not in it.
    struct Springs {
        double normal = 0;
        double shear = 0;
        friend bool operator==(const Springs&, const Springs&) = default;
    };
    Springs springs_of(const TrialContacts& trials, std::size_t contact) const;
    double stiffness_of_bolt(const TrialContacts& trials, std::size_t bolt) const;
    bool is_changed(int row) const {
        return row >= 0 && (changed_.empty() || changed_[static_cast<std::size_t>(row)] != 0);
    }
    /// Takes the springs' present stiffnesses, and marks the rows of those that have changed.
    void update_springs(const TrialContacts& trials);
    void update_bolts(const TrialContacts& trials);
    /// Puts together what a row has on the diagonal and above it, without bolts.
    void assemble_row(std::size_t row);
    void add_bolt(const BoltSpring& bolt, double stiffness);

    const StepProblem& p_;
    const BlockPattern& pattern_;
    BlockMatrix& matrix_;
    const ThreadPool& pool_;
    bool assembled_ = false;
    std::vector<char> changed_;
    std::vector<Springs> contacts_;      ///< in the matrix
    std::vector<char> contact_changed_;  ///< per contact, whether its springs have changed
    std::vector<double> bolts_;          ///< likewise
};

}  // namespace rockslope::dda
