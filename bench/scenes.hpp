#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stage_recorder.hpp"

namespace rockslope::bench {

/// A scene that was run.
struct Outcome {
    std::string scene;
    int blocks = 0;
    std::vector<StageStatistics> stages;
};

/// A running-bond wall of `columns` by `rows` 1 m blocks on a fixed base (penalty ten times Young's modulus):
/// settled, then left to stand. Writes nothing.
/// @param step s, of the standing wall; @param duration s.
/// @throws std::runtime_error when a stage does not reach its end.
Outcome run_wall(int columns, int rows, double step, double duration, int threads);

/// A model file and its block file with all results written to `folder`, as dda-run does.
/// @throws InputError; std::runtime_error when a stage does not reach its end.
Outcome run_model(const std::filesystem::path& run_file, const std::filesystem::path& blocks,
                  const std::filesystem::path& folder, int threads);

}  // namespace rockslope::bench
