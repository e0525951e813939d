#pragma once

#include <cstdint>
#include <vector>

#include "dda/base/phase_times.hpp"
#include "dda/linear/linear_solver.hpp"
#include "dda/solve/methods/patch_balance.hpp"
#include "dda/solve/step_counts.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

struct OpenCloseResult : StepCounts {
    bool converged = false;
    bool singular = false;         ///< the matrix was not positive definite
    bool turns_otherwise = false;  ///< gaps did not settle: a block turns otherwise than predicted
    bool gaps_unsettled = false;   ///< the iteration ended for that, and the mid-step may be predicted anew
    ContactIndex worst_contact = ContactIndex::none();  ///< the contact with the largest force change
    double force_change = 0;                ///< N per metre, the largest force change of the last iteration
    PerRow<Vec6> displacement;              ///< per row
    PerContact<EvaluatedContact> contacts;  ///< per contact
    std::vector<double> bolt_force;         ///< per bolt
};

/// Memory that the caller keeps from step to step.
struct IterationWorkspace {
    BlockMatrix matrix;
    PerContact<ContactTrial> trials;
    PatchBalance::Memory patches;
    PhaseTimes* times = nullptr;  ///< null: no timing
};

/// What the first iterations do: balance blocks in small patches, in one patch of all blocks, or search along
/// lines.
enum class Beginning : std::uint8_t { in_patches, in_one_patch, along_lines };

/// What an iteration came to.
struct IterationOutcome {
    OpenCloseResult result;
    /// Whether the patches led away from the solution, or to a matrix that is not positive definite. The
    /// step may begin anew in another way.
    bool went_astray = false;
    /// Per row: where they did, the displacement that was nearest to balance, m; empty if there is none.
    PerRow<Vec6> nearest;
};

/// Shi's open-close iteration: an active-set (semi-smooth Newton) method. Seeks the displacement of the step
/// in which every contact obeys its joint law (table of states, theory sec. 5).
///
/// Each iteration solves the linear system of the present active set; the friction of sliding contacts
/// follows their normal forces, Eq. (35). The first iterations take that solution, and balance the blocks
/// whose forces do not obey the laws there in patches, Eq. (99). Iterations without patches search along the
/// line to the linear solution, Eq. (34): with fixed shear bounds the step is the minimum of a convex
/// potential, Eq. (33), and this Newton method converges from any start. Where following bounds do not
/// converge, a static step is solved by the interior-point method; in other steps, and where that fails, the
/// bounds are updated only at minima of the potential, with Anderson mixing. Penetration beyond the tolerance
/// of the model is removed by augmented Lagrangian updates, Eq. (37). Converged means that no contact force
/// changes by more than the tolerance, Eq. (36); the states open, sliding and locked are not compared.
IterationOutcome iterate_open_close(const StepProblem& problem, Beginning beginning,
                                    const BlockPattern& pattern, LinearSolver& solver,
                                    IterationWorkspace& work, const ThreadPool& pool);

}  // namespace rockslope::dda
