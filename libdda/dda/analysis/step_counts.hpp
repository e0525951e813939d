#pragma once

namespace rockslope::dda {

/// What it took to find a step's displacement, all attempts together.
struct StepCounts {
    int iterations = 0;  ///< open-close iterations: linear solutions
    int factorizations = 0;
    int substitutions = 0;  ///< forward and backward, of one right-hand side
    int fallbacks = 0;      ///< factorizations made again in double precision, where single was too little

    StepCounts& operator+=(const StepCounts& more) {
        iterations += more.iterations;
        factorizations += more.factorizations;
        substitutions += more.substitutions;
        fallbacks += more.fallbacks;
        return *this;
    }
};

}  // namespace rockslope::dda
