#pragma once

#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/analysis/step_report.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// When and where a block first slipped in the dynamic stages of a run.
struct FirstSlip {
    double sliding_since = -1;  ///< s of the dynamic stages; -1: it does not slide at present
    double time = -1;           ///< s of the run; -1: it has not slipped
    double dynamic_time = -1;   ///< s of the dynamic stages, likewise
    int other = -1;             ///< the block that it slipped on, or that slipped on it
    int joint_material = -1;

    bool has_slipped() const { return dynamic_time >= 0; }
};

/// Looks at an accepted step. Two blocks slide on each other when contacts between them slide and none is
/// locked; they have slipped when one of those has slipped by more than the threshold since displacements
/// count. The time is when that began: the start of the first of the steps in a row, up to this one, in each
/// of which the block slid on some other. So springs that give way a little while the block stays are no
/// slip, and the threshold does not delay the time.
/// @param threshold m, positive; @param slips per block.
void update_first_slips(const Model& model, const State& state, const StepReport& step, double threshold,
                        std::vector<FirstSlip>& slips);

}  // namespace rockslope::dda
