#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/base/read_log.hpp"
#include "dda/model/model.hpp"
#include "dda/model/output_spec.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// The checked input of a run.
struct RunInput {
    Model model;
    std::vector<Stage> stages;
    OutputSpec output;
    std::vector<std::filesystem::path> files;  ///< every file read: model file, block file, records
    std::vector<InputFile> digests;            ///< of these files, each once, as they were read
    /// The effective model file with the digest of each file in place of its path: runs with equal
    /// fingerprints give the same bytes.
    std::string fingerprint;
    std::string effective;  ///< model file with overrides and defaults; it gives the same run when read again
};

/// Command-line options that change the model file.
struct RunReadOptions {
    std::vector<std::string> overrides;           ///< key=value, see ConfigTable
    std::optional<std::filesystem::path> blocks;  ///< block file in place of that in the model file
    std::filesystem::path echo_folder;  ///< folder to which paths in the effective text are relative
};

/// Reads a model file of dda-run, its block file and its records.
/// @throws InputError, one line with the place and what was expected.
RunInput read_run(const std::filesystem::path& run_file, const RunReadOptions& options = {});

/// A commented model file to start from.
std::string run_template();

}  // namespace rockslope::dda
