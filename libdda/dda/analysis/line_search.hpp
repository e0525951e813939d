#pragma once

#include <span>
#include <vector>

#include "dda/analysis/trial_contacts.hpp"

namespace dda {

/// Finds where, on the way from a displacement to the linear system's solution, the step's potential is
/// smallest.
///
/// At the solution the linear forces balance, so the potential's slope along the way is the work of what the
/// laws' forces differ from those, less what the way still to go takes from the quadratic part. It never
/// falls along the way.
class LineSearch {
  public:
    LineSearch(const StepProblem& problem, const TrialContacts& trials, const Crew& crew);

    /// The share of the way, 0 to 1, to 1e-6; exactly 1 where the potential falls all the way.
    /// @param from, target per row, displacements of the step.
    double share(std::span<const Vec6> from, std::span<const Vec6> target);

  private:
    /// A measure along the way: `end` at the target.
    struct Line {
        double end = 0;
        double rate = 0;
        double at(double share) const { return end - (1 - share) * rate; }
    };
    /// A contact's measures, the forces that the linear system gives it at the target, and its laws.
    struct ContactLine {
        Line opening;
        Line shearing;
        Forces linear;
        ContactLaw law;
    };

    void draw(std::span<const Vec6> from, std::span<const Vec6> target);
    ContactLine line_of(std::size_t contact, std::span<const Vec6> target) const;
    /// Between the laws' forces and the linear ones, at the target.
    double largest_difference() const;
    double slope(double share) const;

    const StepProblem& p_;
    const TrialContacts& trials_;
    const Crew& crew_;
    std::vector<Vec6> way_;  ///< per row
    double curvature_ = 0;   ///< of the quadratic part
    std::vector<ContactLine> contacts_;
    std::vector<Line> elongation_;  ///< per bolt
};

}  // namespace dda
