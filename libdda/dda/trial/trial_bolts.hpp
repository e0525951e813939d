#pragma once

#include <vector>

#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// The bolts of a step during the open-close iteration. A bolt that yields is a load in the linear system.
class TrialBolts {
  public:
    /// All bolts are elastic. @param problem must outlive the bolts.
    explicit TrialBolts(const StepProblem& problem);

    /// Whether the spring of a bolt is in the linear system.
    bool is_elastic(std::size_t bolt) const { return yielding_[bolt] == 0; }
    /// The force in the linear system at an elongation of the step, N per metre. @param elongation m.
    double linear_force(std::size_t bolt, double elongation) const;
    /// The force of the law at an elongation of the step, Eq. (38), N per metre. @param elongation m.
    double law_force(std::size_t bolt, double elongation) const;
    /// The force of the law at the iterate, N per metre.
    double force(std::size_t bolt) const { return law_force(bolt, elongation_[bolt]); }

    /// Sets the force of a bolt in the linear system at its solution, N per metre.
    void set_linear_force(std::size_t bolt, double force) { linear_[bolt] = force; }
    /// Sets these forces of all bolts. @param target the solution of the linear system, per row, m.
    void set_target(RowSpan<const Vec6> target);
    /// Moves to an iterate. @param d its displacement, per row, m.
    void move_to(RowSpan<const Vec6> d);
    /// The largest difference between a force of the linear system at its solution and that of the law at the
    /// iterate, N per metre; zero without bolts.
    double force_change() const;
    /// Lets the bolts yield in the linear system that yield at the iterate. @return whether any changed.
    bool update_active_set();

  private:
    /// The force of a bolt that does not yield, N per metre.
    double elastic_force(std::size_t bolt, double elongation) const {
        return p_.bolt_force[bolt] + p_.bolts[bolt].stiffness * elongation;
    }

    const StepProblem& p_;
    std::vector<int> yielding_;       ///< per bolt: the sign of its yielding force, 0 when elastic
    std::vector<double> elongation_;  ///< per bolt, m, in the step
    std::vector<double> linear_;      ///< per bolt: force in the linear system, at its solution, N per metre
};

}  // namespace rockslope::dda
