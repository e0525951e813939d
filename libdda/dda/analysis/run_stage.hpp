#pragma once

#include "dda/analysis/run_observer.hpp"
#include "dda/analysis/step.hpp"

namespace rockslope::dda {

/// Sets the stage's time and step count to zero, the next step to the stage's step, and the origin of the
/// stage's displacements to the present centroids.
void begin_stage(State& state);

/// Runs one stage. `state` always holds the result of the last accepted step. @return how the stage ended.
RunOutcome run_stage(const Model& model, const Stage& stage, TimeStepper& stepper, State& state,
                     RunObserver& observer);

}  // namespace rockslope::dda
