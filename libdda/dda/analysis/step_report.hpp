#pragma once

#include <span>

#include "dda/analysis/state.hpp"
#include "dda/analysis/step_counts.hpp"
#include "dda/analysis/step_problem.hpp"
#include "dda/model/model.hpp"
#include "dda/terms/system.hpp"

namespace rockslope::dda {

/// One accepted step, for the step log.
struct StepReport : StepCounts {
    double time = 0;                        ///< s, at the end of the step
    double step = 0;                        ///< s
    int cuts = 0;                           ///< attempts rejected before this one
    int open = 0, sliding = 0, locked = 0;  ///< contacts by state
    double largest_penetration = 0;         ///< m, of contacts that stand for their depth
    double remaining_dilation = 0;          ///< m, see remaining_dilation()
    double largest_displacement = 0;        ///< of a vertex in this step, m
    double unbalanced_force = 0;  ///< largest over the blocks, of all six unknowns, over the block's weight
    double contact_frequency_step = 0;  ///< omega_contact * dt, the largest of sqrt(k_n / m_block) * dt
};

/// What the state at a step's end tells of the step; its counts are the caller's.
/// @param max_stiffness N/m per metre, of the contacts' springs.
StepReport report_step(const Model& model, const RowMap& rows, const State& after, double step,
                       double max_stiffness);

/// What of a step's dilation acts from the next one on, m: by how much the histories of contacts have moved
/// their faces beyond what the step was solved with, the largest of those that are closed at its end or
/// overlap by then. @param before at the step's start; @param after at its end.
double remaining_dilation(std::span<const Contact> before, std::span<const EvaluatedContact> evaluated,
                          std::span<const Contact> after);

}  // namespace rockslope::dda
