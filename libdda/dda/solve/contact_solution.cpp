#include "dda/solve/contact_solution.hpp"

namespace rockslope::dda {

std::optional<StepBeginning> next_beginning(const StepProblem& problem, const StepBeginning& begun,
                                            const IterationOutcome& outcome) {
    if (!outcome.went_astray) return std::nullopt;
    const bool threw_a_block = outcome.result.gaps_unsettled;
    const bool began_nearest = begun.beginning == Beginning::in_one_patch && !begun.found.empty();
    if (begun.beginning != Beginning::in_patches && !(began_nearest && threw_a_block)) return std::nullopt;
    StepBeginning next;
    next.beginning =
        PatchBalance::suits_one_patch(problem) ? Beginning::in_one_patch : Beginning::along_lines;
    // Linear gaps would balance a thrown block where it is.
    if (!threw_a_block) next.found = outcome.nearest;
    return next;
}

OpenCloseResult solve_contacts(const StepProblem& problem, const BlockPattern& pattern, LinearSolver& solver,
                               IterationWorkspace& work, const ThreadPool& pool) {
    StepBeginning begun{Beginning::in_patches, PerRow<Vec6>(problem.found.begin(), problem.found.end())};
    StepProblem present = problem;
    StepCounts counts;
    for (;;) {
        present.found = begun.found;
        IterationOutcome outcome = iterate_open_close(present, begun.beginning, pattern, solver, work, pool);
        counts += outcome.result;
        std::optional<StepBeginning> next = next_beginning(problem, begun, outcome);
        if (!next) {
            static_cast<StepCounts&>(outcome.result) = counts;
            return std::move(outcome.result);
        }
        begun = *std::move(next);
    }
}

}  // namespace rockslope::dda
