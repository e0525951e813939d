#pragma once

#include <span>
#include <vector>

#include "dda/analysis/trial_contacts.hpp"

namespace rockslope::dda {

/// Finds where, on the way from a displacement to the linear system's solution, the step's potential is
/// smallest.
///
/// At the solution the linear forces balance, so the potential's slope along the way is the work of what the
/// laws' forces differ from those, less what the way still to go takes from the quadratic part. It never
/// falls along the way. Most contacts stay on one straight piece of their laws all the way: their work is a
/// straight line, and only the others are asked again and again.
class LineSearch {
  public:
    LineSearch(const StepProblem& problem, const TrialContacts& trials, const ThreadPool& pool);

    /// The step_length of the way, 0 to 1, to 1e-6; exactly 1 where the potential falls all the way.
    /// @param from, target per row, displacements of the step.
    double step_length(std::span<const Vec6> from, std::span<const Vec6> target);

  private:
    /// A measure along the way: `end` at the target.
    struct Line {
        double end = 0;
        double rate = 0;
        double at(double step_length) const { return end - (1 - step_length) * rate; }
    };
    /// The piece of its laws that a contact is on; what may not close is on the one without any force.
    struct Piece {
        bool active = false;
        bool locked = false;
        bool forward = false;  ///< beyond the bound in that direction
        bool operator==(const Piece&) const = default;
    };
    /// Where a contact is at some step_length.
    struct Sample {
        Piece piece;
        double work =
            0;  ///< of what the laws' forces differ from the linear ones by, J per metre and step_length
    };
    /// A contact's measures, the forces that the linear system gives it at the target, and its laws.
    struct ContactLine {
        Line opening;
        Line shearing;
        Forces linear;
        ContactLaw law;
        // Of a contact with a kink on the way:
        Piece low;      ///< at the lower end of where the smallest potential is known to be
        Piece high;     ///< at the upper
        Sample middle;  ///< where it was asked last

        Sample at(double step_length) const;
        /// Whether its work is a straight line between two places on these pieces.
        bool is_linear(const Piece& from, const Piece& to) const;
        /// How its work grows along a piece that is straight.
        double rate(const Piece& piece) const;
    };
    /// Of all contacts at both ends of the way.
    struct Ends {
        double largest_difference = 0;  ///< between the laws' forces and the linear ones, at the target
        double at_start = 0;            ///< work
        double at_target = 0;           ///< likewise
        Line straight;                  ///< the work of contacts without a kink
    };

    void set_search_direction(std::span<const Vec6> from, std::span<const Vec6> target);
    Ends evaluate_ends(std::span<const Vec6> target);
    void collect_kinked(std::span<const Vec6> target);
    ContactLine line_of(std::size_t contact, std::span<const Vec6> target) const;
    double slope(double step_length);
    /// Takes the step_length asked last as an end of where the smallest potential is.
    void shrink_bracket(bool is_upper, double step_length);
    double bolt_work(double step_length) const;

    const StepProblem& p_;
    const TrialContacts& trials_;
    const ThreadPool& pool_;
    std::vector<Vec6> search_direction_;  ///< per row
    double curvature_ = 0;                ///< of the quadratic part
    Line linear_work_;            ///< the work of contacts without a kink where the smallest potential may be
    std::vector<char> has_kink_;  ///< per contact, on the way
    std::vector<ContactLine> contacts_;  ///< of those that have
    std::vector<std::size_t> kinked_;    ///< of these, those with a kink where the smallest potential may be
    std::vector<Line> elongation_;       ///< per bolt
};

}  // namespace rockslope::dda
