#pragma once

#include <string>
#include <vector>

#include "common/base/read_log.hpp"
#include "dda/analysis/run_observer.hpp"
#include "dda/results/results.hpp"

namespace rockslope::dda {

/// What a run was made from.
struct Provenance {
    std::string version;  ///< of the program
    std::vector<InputFile> inputs;
};

/// The summary of a run as JSON text: outcome, stage, peaks, energies, contacts, reversals that hang on
/// `min_slip`, wall time, version and inputs.
std::string summary_text(const Model& model, const std::vector<Stage>& stages, const State& state,
                         const RunOutcome& outcome, const Results& results, const Provenance& provenance);

}  // namespace rockslope::dda
