#pragma once

#include <vector>

#include "dda/analysis/base_motion.hpp"
#include "dda/analysis/model_scale.hpp"
#include "dda/analysis/prediction.hpp"
#include "dda/analysis/state.hpp"
#include "dda/base/phase_times.hpp"
#include "dda/terms/loads.hpp"

namespace rockslope::dda {

/// Tolerated penetration of a vertex without a contact at the end of a step, over the median edge length. Far
/// below any penetration that matters, far above rounding.
inline constexpr double undetected_depth = 1e-9;

/// The equations of a step: all that is constant during its open-close iteration.
struct StepEquations {
    double dt = 0;  ///< s
    Newmark newmark;
    PrescribedMotion prescribed;
    MidStep mid;
    ContactSet contacts;     ///< at the start of the step
    JointSegments segments;  ///< of the contacts
    PerContact<ContactSprings> springs;
    PerContact<NormalDashpot> dashpots;  ///< empty in static stages
    std::vector<BoltSpring> bolts;
    FreeFieldMotions fields;  ///< at the end of the step
    std::vector<BoundaryTerm> boundaries;
    LoadInstant loads;  ///< at the end of the step
    BaseSystem base;    ///< inertia, elasticity, loads, fixed points and viscous boundaries
};

/// What the equations of all steps of a model have in common.
struct StepSetting {
    const Model& model;
    const RowMap& rows;
    const ModelScale& scale;
    const ThreadPool& pool;
    PhaseTimes* times = nullptr;  ///< null: no timing
};

/// The motion that the velocities predict, and the search radius for it. @param dt s, size of the step.
Prediction initial_prediction(const StepSetting& setting, const Stage& stage, const State& state, double dt);

/// Detects and transfers contacts, and assembles all terms that are constant during the iteration.
/// @param state at the start of the step; @param dt s, its size. @param row_contacts receives the contacts of
/// each row; its memory is kept from step to step.
StepEquations step_equations(const StepSetting& setting, const Stage& stage, const State& state, double dt,
                             const Prediction& prediction, RowContacts& row_contacts);

/// The input of the open-close iteration of a step, without a guess, and with bonds that break at their whole
/// strength. It refers to the equations and to `row_contacts`, their contacts of each row.
StepProblem step_problem(const StepSetting& setting, const Stage& stage, const State& state,
                         const StepEquations& step, const RowContacts& row_contacts);

}  // namespace rockslope::dda
