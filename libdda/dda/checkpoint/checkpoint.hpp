#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dda/analysis/run.hpp"
#include "dda/analysis/state.hpp"
#include "dda/monitor/blocks_on_planes.hpp"
#include "dda/monitor/first_slips.hpp"

namespace rockslope::dda {

/// The largest motion of a tracked point so far.
struct Peaks {
    double displacement = 0, displacement_time = 0;  ///< m, s
    double velocity = 0, velocity_time = 0;          ///< m/s, s
    double acceleration = 0, acceleration_time = 0;  ///< m/s2, s
    double relative = 0, relative_time = 0;          ///< m, s, of the displacement from the reference
};

/// Where the results stand besides the files: part of a checkpoint, so that a continued run keeps the rhythm
/// of the first.
struct ResultsState {
    int stage = 0;                        ///< index of the running stage
    std::int64_t next_frame = 1;          ///< the next due frame, counted from the start of the stage
    std::int64_t next_history = 1;        ///< likewise
    std::int64_t last_frame_step = -1;    ///< step count of the last kept frame
    std::int64_t last_history_step = -1;  ///< likewise
    std::int64_t fallbacks = 0;           ///< as in StepCounts, so far
    double wall_time = 0;                 ///< s, of this and the earlier parts of the run
    double remaining_dilation = 0;        ///< m, as in StepReport, the largest so far
    std::vector<Peaks> peaks;             ///< per tracked point
    std::vector<ReductionTrial> trials;   ///< of the strength reduction, in the order they were made
    std::vector<FirstSlip> first_slips;   ///< per block
    std::vector<BlockOnPlane> planes;     ///< after the first dynamic step
};

/// Everything needed to go on with a run.
struct Checkpoint {
    State state;
    ResultsState results;
    std::map<std::string, std::int64_t> positions;  ///< of each result writer, by name
    std::string input_hash;                         ///< of everything the run was started from
};

/// Writes a checkpoint under a temporary name and renames it. @throws OutputError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);
/// @throws InputError when there is none, or it is not one of this program's.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace rockslope::dda
