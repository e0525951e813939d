#pragma once

#include "dda/analysis/run.hpp"
#include "dda/analysis/step.hpp"

namespace rockslope::dda {

/// Clocks and counters of a stage at its start.
void begin_stage(State& state);

/// Runs one stage on `state`, which always holds the last accepted step. @return how it ended; `completed`
/// lets the run go on.
RunOutcome run_stage(const Model& model, const Stage& stage, TimeStepper& stepper, State& state,
                     RunObserver& observer);

}  // namespace rockslope::dda
