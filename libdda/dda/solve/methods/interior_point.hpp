#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "dda/base/phase_times.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/solve/methods/path_contact.hpp"
#include "dda/solve/step_matrix.hpp"
#include "dda/trial/step_contacts.hpp"

namespace rockslope::dda {

/// How an interior-point solution ended, and its work.
struct InteriorPointResult {
    bool converged = false;  ///< contact forces agree with the laws, and blocks are in balance
    int iterations = 0;      ///< one factorisation each
    int substitutions = 0;
};

/// Where an interior-point solution begins.
struct PathStart {
    /// N per metre, the largest error of the contact forces at the first iterate; nothing if they are far
    /// from the laws.
    std::optional<double> force_change = {};
    bool hold_bounds = false;  ///< hold the shear bounds at those of the present forces
};

/// Solves the contact problem of a step by a primal-dual interior-point method, theory sec. 20: for steps in
/// which so many contacts open, close and slide that the active set of the open-close iteration does not
/// settle. It needs some twenty factorisations, however many contacts change their state.
///
/// No active set is searched. The forces of each contact stay inside their limits, and the products of
/// Eq. (91), by which they are off the laws, fall together to zero [mehrotra1992]. Shear bounds are lines
/// over the normal force (ShearLine), and follow it.
class InteriorPoint {
  public:
    InteriorPoint(const StepProblem& problem, StepContacts& contacts, StepMatrix& matrix,
                  LinearSolver& solver, const ThreadPool& pool, PhaseTimes* times = nullptr);

    /// @param d per row, m: the iterate to begin with on entry, the last one on return; unchanged where no
    /// force acts or an iterate is not finite.
    InteriorPointResult solve(PerRow<Vec6>& d, const PathStart& from);
    /// Sets the forces of the linear system to those of the last solution, which balance.
    void set_linear_forces();

  private:
    static constexpr std::size_t no_path = std::numeric_limits<std::size_t>::max();

    /// The errors of an iterate.
    struct Errors {
        double balance = 0;        ///< N per metre, the largest of a block
        double law = 0;            ///< N per metre, the largest of a contact
        double largest_force = 0;  ///< N per metre, of the contacts
        double mean_product = 0;   ///< N^2 per square metre
    };
    /// Where a change of the unknowns begins.
    enum class Change { prediction, correction };

    /// Calls body(contact) for each contact, in parallel.
    template <class Body>
    void for_contacts(const Body& body);
    void find_contacts(RowSpan<const Vec6> d);
    /// Sets the limits of a contact's forces by the laws.
    void set_limits(PathContact& c, RowSpan<const Vec6> d) const;
    void set_springs(PathContact& c, RowSpan<const Vec6> d) const;
    /// The root mean square of the compressive forces, N per metre.
    double scale_of_forces() const;
    /// Selects the first entrances at the iterate, Eq. (28). Contacts that may close now are placed on the
    /// central path.
    void select_first_entrances(double product);
    /// Holds the bounds of the contacts that block a step, and of all contacts of their blocks.
    void hold_blocking(double step);
    Errors evaluate();
    /// The error of the blocks' balance, N per metre; sets residual_.
    double evaluate_balance();
    bool factorize();
    /// Computes the change that leads the products to their targets.
    void find_change(Change kind);
    /// Solves the coupled system of Eq. (93) with the factor of its symmetric part.
    void solve_coupled(PerRow<Vec6>& x, Change kind);
    /// The shear forces that follow from the normal forces of a displacement, N per metre, per path contact.
    Eigen::VectorXd coupled_shear(RowSpan<const Vec6> displacement) const;
    /// The displacement that shear forces cause, per row, m.
    PerRow<Vec6> displacement_by_shear(const Eigen::VectorXd& shear);
    void apply_factor(PerRow<Vec6>& load);
    /// Adds contact forces to the load. @param force_of gives the force on the corner's block of each path
    /// contact, by its index.
    template <class ForceOf>
    void add_forces(const ForceOf& force_of, RowSpan<Vec6> load) const;
    /// The largest fraction of the change that keeps all unknowns positive.
    double largest_step() const;
    double mean_product(double step) const;
    void advance(double step);

    const StepProblem& p_;
    TrialContacts& trials_;
    ShearBounds& bounds_;
    EntranceLines& entrances_;
    StepMatrix& matrix_;
    LinearSolver& solver_;
    const ThreadPool& pool_;
    PhaseTimes* times_;
    std::vector<PathContact> contacts_;
    PerContact<std::size_t> path_of_;          ///< per contact: its index in contacts_, or no_path
    PerContact<StepMatrix::Springs> springs_;  ///< per contact, in the matrix
    PerRow<Vec6> displacement_;                ///< per row: the iterate, m
    PerRow<Vec6> residual_;                    ///< per row: forces that do not balance
    PerRow<Vec6> change_;                      ///< per row: change of the displacement, m
    Eigen::VectorXd predicted_shear_;          ///< per path contact: the coupled part, N per metre
    PerRow<Vec6> predicted_displacement_;      ///< per row: that it causes, m
    int substitutions_ = 0;
};

template <class ForceOf>
void InteriorPoint::add_forces(const ForceOf& force_of, RowSpan<Vec6> load) const {
    pool_.parallel_for(load.size(), [&](std::size_t begin, std::size_t end) {
        for (const RowIndex row : indices<RowIndex>(begin, end)) {
            for (const ContactIndex k : p_.row_contacts.of(row)) {
                if (path_of_[k] == no_path) continue;
                load[row] += p_.springs[k].rows.project_on_row(row, Vec2(force_of(path_of_[k])));
            }
        }
    });
}

}  // namespace rockslope::dda
