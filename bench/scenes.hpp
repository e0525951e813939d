#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stage_recorder.hpp"

namespace rockslope::bench {

/// Result of running a scene.
struct Outcome {
    std::string scene;
    int blocks = 0;
    std::vector<StageStatistics> stages;
};

/// Runs a running-bond wall of `columns` by `rows` 1 m blocks on a fixed base (penalty ten times Young's
/// modulus): it settles, then stands for `duration`. Writes no results.
/// @param step time step of the standing wall, s. @param duration s.
/// @throws std::runtime_error when a stage does not complete.
Outcome run_wall(int columns, int rows, double step, double duration, int threads);

/// Runs a model file and its block file and writes all results to `folder`, as dda-run does.
/// @throws InputError; std::runtime_error when a stage does not complete.
Outcome run_model(const std::filesystem::path& run_file, const std::filesystem::path& blocks,
                  const std::filesystem::path& folder, int threads);

}  // namespace rockslope::bench
