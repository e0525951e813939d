#pragma once

#include <span>
#include <vector>

#include "dda/contact/contact.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"
#include "dda/terms/springs.hpp"
#include "dda/terms/system.hpp"

namespace dda {

/// One step's equations: everything that the open-close iteration may read and does not change.
struct StepProblem {
    const Model& model;
    const StepControl& control;
    const RowMap& rows;
    const BaseSystem& base;
    const BlockSystem& blocks;          ///< at the start of the step
    std::span<const Vec6> prescribed;   ///< per block, known displacements
    std::span<const Contact> contacts;  ///< at the start of the step
    std::span<const ContactSprings> springs;
    std::span<const BoltSpring> bolts;
    std::span<const double> bolt_force;  ///< at the start of the step, N per metre
    double smallest_force = 0;           ///< N per metre, below which force differences are rounding
};

/// What a contact does at the end of a step.
struct JudgedContact {
    ContactState state = ContactState::open;
    double gap = 0;           ///< m
    double normal_force = 0;  ///< N per metre
    double shear_force = 0;   ///< N per metre
    double displacement = 0;  ///< tangential, of the step, m
    double slip = 0;          ///< plastic part of it, m
    bool torn = false;        ///< bonded at the start, opened in this step
};

struct OpenCloseResult {
    bool converged = false;
    bool singular = false;  ///< the system was not positive definite
    int iterations = 0;     ///< linear solutions
    int factorizations = 0;
    int worst_contact = -1;               ///< the contact whose force moved most in the last iteration
    double force_change = 0;              ///< N per metre, that movement
    std::vector<Vec6> displacement;       ///< per row
    std::vector<JudgedContact> contacts;  ///< per contact
    std::vector<double> bolt_force;       ///< per bolt
};

/// Finds the displacement at which every contact's force is what its law says: open, sliding or locked (Table
/// of states, theory sec. 5).
///
/// With the shear bounds held, the step minimises a convex potential, piecewise quadratic in the contacts'
/// displacements; Newton's method on it is Shi's open-close iteration, and an exact line search makes it
/// converge from anywhere. The bounds follow the normal forces: in every iteration at first, and only at the
/// potential's minimum once that has failed to settle. Converged means that no contact force moves by more
/// than the tolerance, whatever the states are called.
OpenCloseResult iterate_open_close(const StepProblem& problem, const BlockPattern& pattern,
                                   LinearSolver& solver, BlockMatrix& work, const Crew& crew);

}  // namespace dda
