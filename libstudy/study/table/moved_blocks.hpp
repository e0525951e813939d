#pragma once

#include <filesystem>
#include <optional>

namespace rockslope::study {

/// The blocks of a run that moved farther than a limit, relative to the base.
struct MovedBlocks {
    double volume = 0;              ///< m3 per metre of thickness
    std::optional<double> front;    ///< m, x of their farthest corner in the direction in which they moved
    std::optional<double> run_out;  ///< m, from their highest corner at the start to the front, horizontally
    std::optional<double> travel_angle;  ///< rad, below the horizontal, of the line between these two
};

/// Reads the moved blocks from the block table of a run. @param limit m.
/// @throws InputError for a table without the columns of dda-run.
MovedBlocks moved_blocks(const std::filesystem::path& block_table, double limit);

}  // namespace rockslope::study
