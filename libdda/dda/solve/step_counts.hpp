#pragma once

namespace rockslope::dda {

/// The work of solving a step, summed over all attempts.
struct StepCounts {
    int iterations = 0;           ///< open-close iterations, one linear solution each
    int interior_iterations = 0;  ///< those of the interior-point method among them
    int factorizations = 0;       ///< numerical factorisations
    int substitutions = 0;        ///< forward and back substitutions of one right-hand side
    int fallbacks = 0;  ///< factorisations repeated in double precision because single did not suffice

    StepCounts& operator+=(const StepCounts& more) {
        iterations += more.iterations;
        interior_iterations += more.interior_iterations;
        factorizations += more.factorizations;
        substitutions += more.substitutions;
        fallbacks += more.fallbacks;
        return *this;
    }
};

}  // namespace rockslope::dda
