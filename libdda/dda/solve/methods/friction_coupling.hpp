#pragma once

#include <span>
#include <vector>

#include "dda/linear/linear_solver.hpp"
#include "dda/trial/step_contacts.hpp"

namespace rockslope::dda {

/// Friction coupling: makes the friction forces of sliding contacts, which are loads in the linear system,
/// equal to the bounds under the normal forces of its solution, Eq. (35). The coupled equations are
/// unsymmetric. Instead of an unsymmetric factor, each iteration computes by one back-substitution how the
/// normal forces change with the friction forces, and combines all directions so far such that the residual
/// is smallest. For bounds linear in the normal force this is GMRES [Saad & Schultz 1986]; where a bound is
/// cut off at zero it is Newton's method in the space of these directions. The dilation of joint segments
/// that dilate with slip follows their normal forces in the same way.
class FrictionCoupling {
  public:
    FrictionCoupling(const StepProblem& problem, StepContacts& contacts, LinearSolver& solver,
                     const ThreadPool& pool);

    /// Changes the friction forces until the largest residual is below 2 % of its first value or a
    /// twentieth of the force tolerance, or stagnates, in at most twelve back-substitutions. Then sets the
    /// contacts' bounds to the friction forces.
    /// @param d solution with the present friction forces on entry, with the new ones on return.
    /// @return number of back-substitutions.
    int solve(std::span<Vec6> d);

  private:
    /// A sliding contact, and its shear bound as a line over the normal force; forces in N per metre. Or a
    /// joint segment whose dilation follows its normal force: then the bound is the force that the normal
    /// springs exert by that dilation, the friction force the one they exert by the dilation so far.
    struct Sliding {
        ContactIndex contact;      ///< none: a dilating segment
        std::size_t dilation = 0;  ///< its index in JointDilation::by_force()
        double spring = 0;         ///< of a dilating segment: sum of its normal springs, N/m per metre
        double sign = 1;           ///< of its shear force
        ShearLine line;            ///< its shear bound
        double tilt = 0;           ///< of the normal spring, Eq. (83)
        bool bonded = false;
        bool coheres = false;       ///< its cohesion acts in this step, also without a normal force
        double friction_force = 0;  ///< shear force in the linear system
        double by_hardening = 0;    ///< the part of the shear force at the bound that the matrix bears
        double normal = 0;          ///< normal force in the linear system
        double residual = 0;        ///< bound minus friction force, with their sign

        /// A contact that coheres keeps the strength of no normal force where it opens, Eq. (75).
        bool is_bounded() const { return (normal > 0 || bonded || coheres) && line.at(normal) > 0; }
        bool dilates() const { return !contact.exists(); }
        double bound() const {
            if (dilates()) return line.slope * normal + line.cohesion;
            return (is_bounded() ? sign * line.at(normal) - tilt * normal : 0) - by_hardening;
        }
        double bound_slope() const {
            if (dilates()) return line.slope;
            return is_bounded() && normal > line.lowest_normal_force ? sign * line.slope - tilt : 0;
        }
    };
    /// A change of the friction forces, and the changes that follow from it.
    struct Direction {
        std::vector<double> friction_force;  ///< per sliding contact
        std::vector<double> normal;          ///< per sliding contact
        std::vector<double> residual;        ///< per sliding contact, with the present slopes of the bounds
        PerRow<Vec6> displacement;           ///< per row
        double coefficient = 0;              ///< of the direction in the solution
    };

    void find_sliding(std::span<const Vec6> d);
    /// Adds the segments whose dilation follows their normal force.
    void find_dilating(std::span<const Vec6> d);
    /// Computes the shear lines that a joint segment has to compute first. A line is kept, because a new
    /// evaluation of the bound costs more than a back-substitution.
    void complete_lines(std::span<const Vec6> d);
    /// @return the largest magnitude.
    double update_residuals();
    double residual_norm() const;
    /// Sets the load of a change of the friction forces by the residuals.
    void set_load(std::span<Vec6> load);
    /// Computes the direction of a change of the friction forces by the residuals, with one
    /// back-substitution.
    void apply_operator(Direction& direction, std::size_t rows);
    /// Adds the combination of the first `count` directions with the smallest residual.
    void minimize_residual(int count);
    /// Sets the friction forces of the contacts, their bounds, and the changes of dilation.
    void store();

    const StepProblem& p_;
    TrialContacts& trials_;
    ShearBounds& bounds_;
    JointDilation& dilation_;
    LinearSolver& solver_;
    const ThreadPool& pool_;
    std::vector<char> slides_;  ///< work space
    std::vector<std::size_t> sliding_contacts_;
    std::vector<Sliding> sliding_;
    PerContact<double> force_change_;   ///< per contact, of the friction force, N per metre
    PerContact<double> normal_change_;  ///< per contact, of the normal force by dilation, N per metre
    std::vector<Direction> directions_;
};

}  // namespace rockslope::dda
