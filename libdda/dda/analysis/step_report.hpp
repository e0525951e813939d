#pragma once

#include <vector>

#include "common/base/thread_pool.hpp"
#include "dda/analysis/counter_slips.hpp"
#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"
#include "dda/solve/step_counts.hpp"
#include "dda/terms/system.hpp"
#include "dda/trial/step_problem.hpp"

namespace rockslope::dda {

/// One accepted step, for the step log.
struct StepReport : StepCounts {
    double time = 0;                        ///< s, at the end of the step
    double step = 0;                        ///< s
    int cuts = 0;                           ///< trial steps rejected before this one
    int open = 0, sliding = 0, locked = 0;  ///< contacts by state
    double largest_penetration = 0;         ///< m, over contacts that account for their penetration
    double remaining_dilation = 0;          ///< m, see remaining_dilation()
    double largest_displacement = 0;        ///< m, of a vertex in this step
    double unbalanced_force = 0;            ///< largest acceleration of a block over gravity, see report_step
    double contact_frequency_step = 0;      ///< sqrt(k / m) * dt, stiffest spring and lightest block
    bool at_rest = false;                   ///< the step ends a static stage, see run_stage()
    std::vector<JointCounterSlip> ended_counter_slips;  ///< see ended_counter_slips()
};

/// The acceleration that scales unbalanced forces, m/s2: gravity, or the largest acceleration by a load where
/// that is larger, or 1 where both are zero.
double reference_acceleration(const Model& model, const BlockSystem& blocks);

/// The unbalanced force of a block over its weight: its acceleration over `reference`, m/s2. Rotation and
/// strains count as the accelerations that they cause at the radius of gyration.
double unbalanced_force(const BlockSystem& blocks, BlockIndex block, double reference);

/// Computes the report from the state after the step. The caller fills in the StepCounts. Where a load
/// accelerates a block by more than gravity, the unbalanced force is over that acceleration.
/// @param step s, size of the step; @param max_stiffness N/m per metre, largest stiffness of a contact
/// spring.
StepReport report_step(const Model& model, const RowMap& rows, const State& after, double step,
                       double max_stiffness, const ThreadPool& pool);

/// The dilation that the step leaves to the next one, m: the largest difference between the dilation of a
/// history and that of its contact, and of a contact that is open and overlaps, between the dilation that its
/// history advances by and the dilation that the step was solved with.
/// @param before, after contacts at the start and at the end of the step.
double remaining_dilation(const Model& model, ContactSpan<const EvaluatedContact> evaluated,
                          ContactSpan<const Contact> before, ContactSpan<const Contact> after,
                          const ThreadPool& pool);

}  // namespace rockslope::dda
