#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/base/read_log.hpp"
#include "dda/analysis/run_observer.hpp"
#include "dda/results/results.hpp"

namespace rockslope::dda {

/// What a run was made from.
struct Provenance {
    std::string version;                        ///< of the program
    std::string commit = {};                    ///< of its sources
    std::vector<InputFile> inputs = {};         ///< as they were read
    std::string fingerprint = {};               ///< digest of all that the results depend on
    std::vector<std::string> overrides = {};    ///< of the command line, key=value
    std::optional<InputFile> saved_state = {};  ///< that the run began with
    int threads = 1;
    std::string kernel = {};                 ///< vector extension of the solver, see FrontKernels::name
    bool fused = true;                       ///< FrontKernels::fused of that kernel
    std::vector<std::string> warnings = {};  ///< what the program said of the run
};

/// The summary of a run as JSON text: outcome, stage, peaks, energies, contacts, reversals that hang on
/// `min_slip`, measures of the motions, wall time and provenance.
std::string summary_text(const Model& model, const std::vector<Stage>& stages, const State& state,
                         const RunOutcome& outcome, const Results& results, const Provenance& provenance);

}  // namespace rockslope::dda
