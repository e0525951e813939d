#pragma once

#include <vector>

#include "dda/analysis/step_counts.hpp"
#include "dda/analysis/step_problem.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/linear/linear_solver.hpp"

namespace rockslope::dda {

struct OpenCloseResult : StepCounts {
    bool converged = false;
    bool singular = false;                   ///< the system was not positive definite
    int worst_contact = -1;                  ///< the contact whose force moved most in the last iteration
    double force_change = 0;                 ///< N per metre, that movement
    std::vector<Vec6> displacement;          ///< per row
    std::vector<EvaluatedContact> contacts;  ///< per contact
    std::vector<double> bolt_force;          ///< per bolt
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
                                   LinearSolver& solver, BlockMatrix& work, const ThreadPool& pool,
                                   PhaseTimes* times = nullptr);

}  // namespace rockslope::dda
