#pragma once

#include <string>

namespace rockslope::dda {

/// The results that a run writes.
struct OutputSpec {
    std::string name = "run";  ///< stem of the result files
    int frames = 200;          ///< frames, evenly over the dynamic stages, besides both ends of every stage
    bool joint_frames = true;  ///< frames of the contacts beside those of the blocks
    bool step_log = true;      ///< steps.csv
    int static_frame_interval = 0;   ///< steps between frames inside static stages; 0: none
    double history_interval = 0.01;  ///< s between the rows of history.csv; 0: every step
    /// Measured point or prescribed block whose motion is subtracted in relative.csv and in permanent
    /// displacements; empty: none.
    std::string relative_to = {};
    double slip_threshold = 1e-4;     ///< m, slip of a contact above which its blocks have slipped
    bool save_stages = false;         ///< the state at the end of every stage is saved, to branch from
    double checkpoint_interval = 60;  ///< s of wall time between checkpoints
};

}  // namespace rockslope::dda
