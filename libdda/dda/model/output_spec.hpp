#pragma once

#include <string>

namespace rockslope::dda {

/// What a run keeps.
struct OutputSpec {
    std::string name = "run";  ///< stem of the result files
    int frames = 200;  ///< kept frames, evenly over the dynamic stages, besides both ends of every stage
    int static_frame_interval = 0;   ///< steps between kept frames inside static stages; 0: none
    double history_interval = 0.01;  ///< s between the rows of history.csv; 0: every step
    /// Measured point or prescribed block that relative.csv and permanent displacements count from; empty:
    /// none.
    std::string relative_to = {};
    double slip_threshold = 1e-4;     ///< m, of slip at a contact, from which on its blocks have slipped
    double checkpoint_interval = 60;  ///< s of wall time between checkpoints
};

}  // namespace rockslope::dda
