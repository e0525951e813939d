#pragma once

#include "dda/analysis/state.hpp"
#include "dda/analysis/step_report.hpp"

namespace rockslope::dda {

/// The first slip of a block in the dynamic stages of a run.
struct FirstSlip {
    double sliding_since = -1;              ///< s of dynamic time; -1: it does not slide at present
    double time = -1;                       ///< s of the run, of the first slip; -1: it has not slipped
    double dynamic_time = -1;               ///< s of dynamic time, of the first slip; -1: it has not slipped
    BlockIndex other = BlockIndex::none();  ///< the other block of the contact that slipped
    JointMaterialIndex joint_material = JointMaterialIndex::none();

    bool has_slipped() const { return dynamic_time >= 0; }
};

/// Updates the first slips with an accepted step. Two blocks slide on each other if at least one contact
/// between them slides and none is locked. They have slipped once the slip of such a contact exceeds the
/// threshold. The time of the slip is the start of the uninterrupted sequence of sliding steps that led to
/// it. Elastic shear of the springs is therefore no slip, and the threshold does not delay the time.
/// @param threshold m, positive; @param slips per block.
void update_first_slips(const Model& model, const State& state, const StepReport& step, double threshold,
                        PerBlock<FirstSlip>& slips);

}  // namespace rockslope::dda
