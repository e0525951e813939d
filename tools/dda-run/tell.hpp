#pragma once

#include <filesystem>
#include <vector>

#include "dda/analysis/run_observer.hpp"
#include "dda/input/read_run.hpp"
#include "dda/results/block_table.hpp"
#include "dda/results/results.hpp"
#include "warnings.hpp"

namespace rockslope {

/// Tells the user of a run before it starts: its size, and what of its input can hardly be meant.
/// @param folder of the results.
void tell_of_plan(const dda::RunInput& input, const std::filesystem::path& folder, Warnings& warnings);

/// Prints the table of a run's results, and warns of what makes them doubtful. @param state at the run's end;
/// @param slips of blocks on planes.
void tell_of_results(const dda::RunInput& input, const dda::State& state, const dda::RunOutcome& outcome,
                     const dda::Results& results, const std::vector<dda::PlaneSlip>& slips,
                     Warnings& warnings);

/// Says how the run ended. @param wall_time s; @param folder of the results.
void tell_of_end(const dda::RunOutcome& outcome, const dda::State& state, double wall_time,
                 const std::filesystem::path& folder);

}  // namespace rockslope
