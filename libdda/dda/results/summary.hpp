#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/analysis/run_observer.hpp"
#include "dda/results/results.hpp"

namespace rockslope::dda {

/// An input file of a run.
struct InputFile {
    std::string path;
    std::string sha256;
};

/// What a run was made from.
struct Provenance {
    std::string version;  ///< of the program
    std::vector<InputFile> inputs;
};

/// Reads and hashes files. @throws InputError for one that cannot be read.
std::vector<InputFile> hash_files(const std::vector<std::filesystem::path>& files);

/// The summary of a run as JSON text: outcome, stage, peaks, energies, contacts, reversals that hang on
/// `min_slip`, wall time, version and inputs.
std::string summary_text(const Model& model, const std::vector<Stage>& stages, const State& state,
                         const RunOutcome& outcome, const Results& results, const Provenance& provenance);

}  // namespace rockslope::dda
