#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "dda/analysis/run_observer.hpp"
#include "dda/analysis/state.hpp"
#include "dda/monitor/blocks_on_planes.hpp"
#include "dda/monitor/close_reversals.hpp"
#include "dda/monitor/farthest_block.hpp"
#include "dda/monitor/first_slips.hpp"
#include "dda/monitor/left_moving.hpp"
#include "dda/monitor/low_pass.hpp"
#include "dda/monitor/region_motion.hpp"

namespace rockslope::dda {

/// Peak motions of a tracked point so far, with their times.
struct Peaks {
    double displacement = 0, displacement_time = 0;  ///< m, s
    double velocity = 0, velocity_time = 0;          ///< m/s, s
    double acceleration = 0, acceleration_time = 0;  ///< m/s2, s
    double relative = 0, relative_time = 0;          ///< m, s, of the displacement relative to the reference
    double smooth_acceleration = 0;                  ///< m/s2, of the acceleration below smooth_corner
    LowPass smooth;                                  ///< its filter
};

/// Corner frequency of the filter of accelerations for the amplification, Hz: a slope amplifies the shaking
/// at a few hertz, while the impact of two blocks is a spike of a step or two.
inline constexpr double smooth_corner = 25;

/// State of the results other than the files. It is stored in checkpoints, so that a resumed run writes
/// frames and rows at the same times.
struct ResultsState {
    int stage = 0;                          ///< index of the running stage
    std::int64_t next_frame = 1;            ///< number of the next frame due, from the stage's start
    std::int64_t next_history = 1;          ///< number of the next history row due, from the stage's start
    std::int64_t last_frame_step = -1;      ///< step count of the last frame
    std::int64_t last_history_step = -1;    ///< step count of the last history row
    std::int64_t fallbacks = 0;             ///< sum of StepReport::fallbacks so far
    double wall_time = 0;                   ///< s, of this and the earlier parts of the run
    double remaining_dilation = 0;          ///< m, largest of StepReport::remaining_dilation so far
    std::vector<Peaks> peaks;               ///< per tracked point
    std::vector<RegionPeaks> regions;       ///< per measured region
    std::optional<FarthestBlock> farthest;  ///< at its peak
    std::vector<ReductionTrial> trials;   ///< of the strength reduction, in the order in which they were made
    PerBlock<FirstSlip> first_slips;      ///< per block
    std::vector<BlockOnPlane> planes;     ///< found after the first dynamic step
    CloseReversals close_reversals;       ///< whose counter-slips have ended
    std::vector<LeftMoving> left_moving;  ///< by all static stages so far
};

/// Everything needed to resume a run.
struct Checkpoint {
    State state;
    ResultsState results;
    std::map<std::string, std::int64_t> positions;  ///< ResultWriter::position() by WriterEntry::name
    std::map<std::string, std::string> digests;     ///< ResultWriter::digest(), where there is one
    std::string input_hash;                         ///< hash of all input of the run
    /// The input that a state saved at the end of a stage depends on, see start_of_run(). Empty in a
    /// checkpoint from within a stage.
    std::string start_of_run = {};
};

/// Writes a checkpoint as a PendingFile, with the digest of its bytes at its end. @throws OutputError.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);
/// @throws InputError if there is none, or if it is damaged or of another version.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace rockslope::dda
