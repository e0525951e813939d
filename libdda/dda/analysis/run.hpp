#pragma once

#include <optional>
#include <span>

#include "dda/analysis/run_observer.hpp"

namespace rockslope::dda {

struct RunOptions {
    int threads = 1;
    int first_stage = 0;                 ///< index of the first stage to run
    bool resumed = false;                ///< the state is from the middle of first_stage
    std::optional<int> last_stage = {};  ///< index of the last stage to run; none: all
};

/// The state before the first step of a run.
State initial_state(const Model& model);

/// Runs the stages in order. `state` always holds the result of the last accepted step.
RunOutcome run(const Model& model, std::span<const Stage> stages, State& state, RunObserver& observer,
               const RunOptions& options = {});

}  // namespace rockslope::dda
