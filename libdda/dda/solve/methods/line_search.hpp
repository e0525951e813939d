#pragma once

#include <vector>

#include "dda/trial/trial_contacts.hpp"

namespace rockslope::dda {

/// Exact line search: minimises the convex potential of the step, Eq. (33), on the segment from the present
/// displacement to the solution of the linear system, the target of the Newton step.
///
/// The forces of the linear system balance at the target. The directional derivative of the potential at step
/// length s is therefore
///   sum over contacts of (force of the law at s - linear force at the target) times rate
///   - (1 - s) times the curvature of the quadratic part.
/// It increases monotonically with s, so bisection finds its zero. Most contacts stay on one linear piece of
/// their laws on the whole segment, and their term is linear in s. Only contacts with a kink are evaluated
/// again.
class LineSearch {
  public:
    LineSearch(const StepProblem& problem, const TrialContacts& trials, const ThreadPool& pool);

    /// The step length, Eq. (34), in (0, 1], with an error below 1e-6. It is exactly 1 if the potential
    /// decreases up to the target, or if laws and linear system agree there. @param from, target
    /// displacements of the step, per row.
    double step_length(RowSpan<const Vec6> from, RowSpan<const Vec6> target);

  private:
    /// A quantity that is linear in the step length.
    struct Line {
        double end = 0;   ///< value at the target, step length 1
        double rate = 0;  ///< derivative with respect to the step length
        double at(double step_length) const { return end - (1 - step_length) * rate; }
    };
    /// The linear pieces of the normal and the shear law that a contact is on. A contact that may not close
    /// is on the piece without force.
    struct Piece {
        bool active = false;
        ShearPiece shear = ShearPiece::locked;
        bool crossed = false;  ///< the bounds have crossed: as they harden, pieces may return
        bool operator==(const Piece&) const = default;
    };
    /// A contact at some step length.
    struct Sample {
        Piece piece;
        /// Its term of the directional derivative: force of the law less linear force, times rate. J per
        /// metre
        double work = 0;
    };
    /// A contact on the segment: its displacements, its forces in the linear system at the target, its laws.
    struct ContactLine {
        Line opening;
        Line shearing;
        Forces linear;
        ContactLaw law;
        // Only for a contact with a kink:
        Piece low;      ///< at the lower end of the bracket
        Piece high;     ///< at the upper end of the bracket
        Sample middle;  ///< at the step length evaluated last

        Sample at(double step_length) const;
        /// Whether its work is linear in the step length between two points on these pieces.
        bool is_linear(const Piece& from, const Piece& to) const;
        /// How the shear force grows on a linear piece, N/m per metre.
        double shear_stiffness(ShearPiece piece) const;
        /// The derivative of its work with respect to the step length on a linear piece.
        double rate(const Piece& piece) const;
    };
    /// Sums over all contacts at both ends of the segment.
    struct Ends {
        double largest_difference = 0;  ///< N per metre, of law and linear forces at the target
        double at_start = 0;            ///< work at step length 0, J per metre
        double at_target = 0;           ///< work at step length 1, J per metre
        Line linear_work;               ///< work of contacts without a kink
    };

    void set_search_direction(RowSpan<const Vec6> from, RowSpan<const Vec6> target);
    Ends evaluate_ends(RowSpan<const Vec6> target);
    void collect_kinked(RowSpan<const Vec6> target);
    ContactLine line_of(ContactIndex contact, RowSpan<const Vec6> target) const;
    /// The directional derivative of the potential, J per metre.
    double slope(double step_length);
    /// Makes the step length evaluated last the upper or lower end of the bracket.
    void shrink_bracket(bool is_upper, double step_length);
    double bolt_work(double step_length) const;

    const StepProblem& p_;
    const TrialContacts& trials_;
    const ThreadPool& pool_;
    PerRow<Vec6> search_direction_;      ///< per row
    double curvature_ = 0;               ///< of the quadratic part of the potential in the search direction
    Line linear_work_;                   ///< work of contacts without a kink inside the bracket
    PerContact<char> has_kink_;          ///< per contact, on the whole segment
    std::vector<ContactLine> contacts_;  ///< contacts with a kink on the segment
    std::vector<std::size_t> kinked_;    ///< indices into contacts_: those with a kink inside the bracket
    std::vector<Line> elongation_;       ///< per bolt
};

}  // namespace rockslope::dda
