#pragma once

#include <optional>

#include "dda/solve/open_close_iteration.hpp"

namespace rockslope::dda {

/// How the iteration of a step begins.
struct StepBeginning {
    Beginning beginning = Beginning::in_patches;
    PerRow<Vec6>
        found;  ///< per row: displacement there, m; empty: at the linear solution of its first states
};

/// How a step begins anew after an iteration whose patches led astray: a dynamic one of smooth joints in one
/// patch of all blocks, another along lines. One patch begins at the nearest displacement of the patches; but
/// where a block was thrown, by the patches or from there, at the linear solution.
/// @param begun how that iteration began. @return nothing where its outcome is that of the step.
std::optional<StepBeginning> next_beginning(const StepProblem& problem, const StepBeginning& begun,
                                            const IterationOutcome& outcome);

/// Solves the contact problem of a step: by iterate_open_close(), from one beginning after the other
/// (theory sec. 22). @return the last outcome, with the counts of all.
OpenCloseResult solve_contacts(const StepProblem& problem, const BlockPattern& pattern, LinearSolver& solver,
                               IterationWorkspace& work, const ThreadPool& pool);

}  // namespace rockslope::dda
