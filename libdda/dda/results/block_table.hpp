#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dda/results/results.hpp"

namespace rockslope::dda {

/// Newmark's estimate beside the run, for a block that rests on one plane.
struct PlaneSlip {
    BlockOnPlane plane;
    double yield = 0;    ///< horizontal acceleration of the ground at which it begins to slide, over gravity
    double newmark = 0;  ///< m downhill, by the rigid block
    double simulated = 0;  ///< m, likewise, in the run
};
std::vector<PlaneSlip> plane_slips(const Model& model, const std::vector<Stage>& stages, const State& state,
                                   const Results& results);

/// What became of every free block, as CSV: where it is, how far it went, when it first slipped and on what,
/// and of blocks on planes the estimate. @param path of the file, for messages. @throws OutputError for a
/// number that is not finite.
std::string block_table(const Model& model, const State& state, const Results& results,
                        const std::vector<PlaneSlip>& slips, const std::filesystem::path& path);

/// What a run tells who started it, lines of text: permanent displacements and amplification of the points,
/// the first slip, blocks on planes beside their estimates. Empty for a run without dynamic stages.
std::string outcome_table(const Model& model, const State& state, const Results& results,
                          const std::vector<PlaneSlip>& slips);

}  // namespace rockslope::dda
