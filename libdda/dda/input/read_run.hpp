#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dda/model/model.hpp"
#include "dda/model/output_spec.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// Everything a run needs, read and checked.
struct RunInput {
    Model model;
    std::vector<Stage> stages;
    OutputSpec output;
    std::vector<std::filesystem::path> files;  ///< every file read: model file, block file, records
    std::string effective;  ///< the model file with overrides and defaults: reads back to the same run
};

/// What the command line adds to a model file.
struct RunReadOptions {
    std::vector<std::string> overrides;           ///< key=value, see ConfigTable
    std::optional<std::filesystem::path> blocks;  ///< block file in place of the one named
    std::filesystem::path
        echo_folder;  ///< folder the effective text is for; paths in it are relative to that
};

/// Reads a model file for the simulator, the block file it names and the records.
/// @throws InputError, one line with the place and the expectation.
RunInput read_run(const std::filesystem::path& run_file, const RunReadOptions& options = {});

/// A commented model file to start from.
std::string run_template();

}  // namespace rockslope::dda
