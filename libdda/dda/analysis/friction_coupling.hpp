#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "dda/analysis/trial_contacts.hpp"
#include "dda/linear/linear_solver.hpp"

namespace rockslope::dda {

/// The shear forces of sliding contacts, which the linear system holds, brought to the bounds that belong to
/// the normal forces of its own solution, Eq. (35). The coupling makes the equations unsymmetric; instead of
/// a second kind of factor, each back-substitution tells what a change of the held forces does to the normal
/// forces, and of all the directions told so far those coefficients are taken that leave the least
/// differences. With bounds straight over the normal force that is the generalised minimal residual method
/// [Saad & Schultz 1986]; where a bound ends at zero it is Newton's method in the space of these directions.
class FrictionCoupling {
  public:
    FrictionCoupling(const StepProblem& problem, TrialContacts& trials, LinearSolver& solver,
                     const ThreadPool& pool);

    /// Changes the held forces until the largest difference is a share of what it was, or half of what counts
    /// as converged, or no longer falls; the contacts' bounds become the held forces.
    /// @param d the solution with the held forces; it goes with them.
    /// @return back-substitutions taken.
    int solve(std::span<Vec6> d);

  private:
    /// A contact that slides, and its shear bound as a line over the normal force: forces in N per metre.
    struct Sliding {
        std::size_t contact = 0;
        double sign = 1;                 ///< of its shear force
        double slope = 0;                ///< of the bound over the normal force
        double cohesion = 0;             ///< the bound where the line meets no normal force
        double lowest_normal_force = 0;  ///< the normal force below which the bound falls no further
        bool bonded = false;
        bool line_missing = false;  ///< which has to be found first
        double friction_force = 0;  ///< shear force in the linear system
        double normal = 0;          ///< normal force in the linear system
        double residual = 0;        ///< bound less friction force, with their sign

        double line() const { return slope * std::max(normal, lowest_normal_force) + cohesion; }
        bool is_bounded() const { return (normal > 0 || bonded) && line() > 0; }
        double bound() const { return is_bounded() ? sign * line() : 0; }
        double bound_slope() const { return is_bounded() && normal > lowest_normal_force ? sign * slope : 0; }
    };
    /// A change of the held forces, and what comes of it.
    struct Direction {
        std::vector<double> friction_force;  ///< per sliding contact
        std::vector<double> normal;          ///< likewise
        std::vector<double> residual;        ///< likewise, as the bounds are sloped at present
        std::vector<Vec6> displacement;      ///< per row
        double coefficient = 0;              ///< of it that has been made
    };

    /// Coefficients of friction of a joint material of Mohr and Coulomb's law.
    struct FrictionCoefficients {
        double intact = 0;
        double residual = 0;
    };

    void find_sliding(std::span<const Vec6> d);
    /// Sets the line. Mohr and Coulomb's is the law itself. Rough faces' touches their bound where the
    /// contacts were evaluated last; of the others it is the chord from the first solution to half its normal
    /// force. Finding the bound anew costs more than a back-substitution.
    void linearize_bound(Sliding& sliding, std::span<const Vec6> d) const;
    void complete_lines(std::span<const Vec6> d);
    /// @return the largest of them.
    double update_residuals();
    double residual_norm() const;
    /// The load of a change of the held forces by their differences.
    void set_load(std::span<Vec6> load);
    /// Finds out what a change of the held forces by their differences does.
    void apply_operator(Direction& direction, std::size_t rows);
    /// Makes the directions, of the first `count`, that leave the least differences.
    void minimize_residual(int count);

    const StepProblem& p_;
    TrialContacts& trials_;
    LinearSolver& solver_;
    const ThreadPool& pool_;
    std::vector<FrictionCoefficients> friction_coefficients_;  ///< per joint material
    std::vector<Sliding> sliding_;
    std::vector<double> force_change_;  ///< per contact, of the shear force, N per metre
    std::vector<Direction> directions_;
};

}  // namespace rockslope::dda
