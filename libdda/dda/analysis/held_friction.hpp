#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "dda/analysis/trial_contacts.hpp"
#include "dda/linear/linear_solver.hpp"

namespace dda {

/// The shear forces of sliding contacts, which the linear system holds, brought to the bounds that belong to
/// the normal forces of its own solution, Eq. (34). The coupling makes the equations unsymmetric; instead of
/// a second kind of factor, each back-substitution tells what a change of the held forces does to the normal
/// forces, and of all the changes told so far those shares are taken that leave the least differences. With
/// bounds straight over the normal force that is the generalised minimal residual method [Saad & Schultz
/// 1986]; where a bound ends at zero it is Newton's method in the space of these changes.
class HeldFriction {
  public:
    HeldFriction(const StepProblem& problem, TrialContacts& trials, LinearSolver& solver, const Crew& crew);

    /// Changes the held forces until the largest difference is a share of what it was, or half of what counts
    /// as converged, or no longer falls; the contacts' bounds become the held forces.
    /// @param d the solution with the held forces; it goes with them.
    /// @return back-substitutions taken.
    int agree(std::span<Vec6> d);

  private:
    /// A contact that slides, and its shear bound as a line over the normal force: forces in N per metre.
    struct Sliding {
        std::size_t contact = 0;
        double sign = 1;      ///< of its shear force
        double slope = 0;     ///< of the bound over the normal force
        double cohesion = 0;  ///< the bound where the line meets no normal force
        double least = 0;     ///< the normal force below which the bound falls no further
        bool bonded = false;
        bool lacks_line = false;  ///< which has to be found first
        double held = 0;          ///< shear force in the linear system
        double normal = 0;        ///< normal force in the linear system
        double difference = 0;    ///< bound less held force, with their sign

        double line() const { return slope * std::max(normal, least) + cohesion; }
        bool is_bounded() const { return (normal > 0 || bonded) && line() > 0; }
        double bound() const { return is_bounded() ? sign * line() : 0; }
        double bound_slope() const { return is_bounded() && normal > least ? sign * slope : 0; }
    };
    /// A change of the held forces, and what comes of it.
    struct Change {
        std::vector<double> held;        ///< per sliding contact
        std::vector<double> normal;      ///< likewise
        std::vector<double> difference;  ///< likewise, as the bounds are sloped at present
        std::vector<Vec6> displacement;  ///< per row
        double share = 0;                ///< of it that has been made
    };

    /// Coefficients of friction of a joint material of Mohr and Coulomb's law.
    struct Friction {
        double intact = 0;
        double residual = 0;
    };

    void find_sliding(std::span<const Vec6> d);
    /// Sets the line. Mohr and Coulomb's is the law itself. Rough faces' touches their bound where the
    /// contacts were judged last; of the others it is the chord from the first solution to half its normal
    /// force. Finding the bound anew costs more than a back-substitution.
    void draw_line(Sliding& sliding, std::span<const Vec6> d) const;
    void find_missing_lines(std::span<const Vec6> d);
    /// @return the largest of them.
    double find_differences();
    double norm_of_differences() const;
    /// The load of a change of the held forces by their differences.
    void put_load(std::span<Vec6> load);
    /// Finds out what a change of the held forces by their differences does.
    void tell(Change& change, std::size_t rows);
    /// Makes the changes, of the first `count`, that leave the least differences.
    void make_least(int count);

    const StepProblem& p_;
    TrialContacts& trials_;
    LinearSolver& solver_;
    const Crew& crew_;
    std::vector<Friction> friction_;  ///< per joint material
    std::vector<Sliding> sliding_;
    std::vector<double> change_of_;  ///< per contact, of the shear force, N per metre
    std::vector<Change> changes_;
};

}  // namespace dda
