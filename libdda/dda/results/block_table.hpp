#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/results/results.hpp"

namespace rockslope::dda {

/// Slip of a block on a plane: Newmark's estimate and the run.
struct PlaneSlip {
    BlockOnPlane plane;
    double yield = 0;                  ///< Newmark's yield coefficient, see yield_coefficient
    double newmark = 0;                ///< m downhill, of the rigid block
    double simulated = 0;              ///< m downhill, in the run
    std::vector<std::string> ignored;  ///< see ignored_by_estimate
};
std::vector<PlaneSlip> plane_slips(const Model& model, const std::vector<Stage>& stages, const State& state,
                                   const Results& results);

/// The final state of every free block, as CSV: position, displacement, first slip and, for blocks on planes,
/// Newmark's estimate. @param path of the file, for messages. @throws OutputError for a number that is not
/// finite.
std::string block_table(const Model& model, const State& state, const Results& results,
                        const std::vector<PlaneSlip>& slips, const std::filesystem::path& path);

/// The outcome of a run as text for the terminal: permanent displacements and amplification of the points,
/// the first slip, blocks on planes with their estimates. Empty for a run without dynamic stages.
std::string outcome_table(const Model& model, const State& state, const Results& results,
                          const std::vector<PlaneSlip>& slips);

}  // namespace rockslope::dda
