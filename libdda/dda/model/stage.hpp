#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dda/base/types.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

enum class StageKind { static_equilibrium, dynamic };

/// How the step is chosen and when it is refused. The defaults are Shi's where he gives one [Shi 1993, ch.
/// 4].
struct StepControl {
    double step = 0.005;          ///< s, the largest step
    double smallest_step = 1e-9;  ///< s; a step that would have to be smaller ends the run with the reason
    double cut = 1.0 / 3.0;       ///< factor on the step after a rejection
    double growth = 1.3;          ///< factor on the step after an easy step, up to `step`
    int iteration_limit = 100;    ///< open-close iterations in a step
    double displacement_ratio = 0.01;  ///< largest vertex displacement in a step over the model's half-height
    double force_tolerance =
        1e-6;  ///< largest change of a contact force over the reference force, at convergence
};

/// Acceleration of the prescribed block of that name, or of all prescribed blocks when `block` is empty,
/// m/s2. Fixed blocks stay. Outside its table the acceleration is zero. Times count from the stage's start.
struct BaseMotion {
    std::string block;
    TimeTable x;
    TimeTable y;
};

/// A search for the factor of safety, in place of a static stage.
struct StrengthReduction {
    double lowest = 0.1;            ///< factors tried are not below this
    double highest = 10;            ///< nor above this
    double width = 0.01;            ///< of the final bracket, its larger factor over the smaller less 1
    double displacement_limit = 0;  ///< m; a block that moves farther has failed
};

/// A wave that enters through viscous boundaries of that name (through all without a free field when empty):
/// the velocity, m/s, with which its own motion passes them, or the traction, Pa, with which it pushes the
/// rock there. Zero outside the tables. Times count from the stage's start.
struct IncidentWave {
    std::string boundary;
    TimeTable x;
    TimeTable y;
    bool x_is_traction = false;
    bool y_is_traction = false;
};

/// One part of a run.
struct Stage {
    std::string name;
    StageKind kind = StageKind::dynamic;
    double duration = 0;  ///< s, of a dynamic stage
    double dynamic_coefficient =
        1;                      ///< share of the velocity kept from step to step; static stages keep none
    double tolerance = 1e-6;    ///< static: unbalanced force over weight at which the stage ends
    int step_limit = 20000;     ///< static: steps after which the stage has failed to settle
    double newmark_beta = 0.5;  ///< Newmark's parameters; (1/2, 1) is Shi's integration
    double newmark_gamma = 1.0;
    double mass_damping = 0;           ///< 1/s, mass-proportional damping
    bool reset_displacements = true;   ///< static: measured points and slips count from the end of this stage
    bool reset_joint_history = false;  ///< static: joints forget their slip at the end of this stage
    StepControl control;
    std::vector<BaseMotion> base_motions;
    /// Accelerations of the frame that the stage is computed in, m/s2: bases stay, and everything feels the
    /// opposite acceleration. Their `block` has no meaning.
    std::vector<BaseMotion> frame_motions;
    std::optional<StrengthReduction> strength_reduction;  ///< of a static stage: what it is for
    std::vector<IncidentWave> incident_waves;
};

/// The first of the instants k * step, k = 1, 2, ..., later than the given time, s since the stage's start.
/// The steps of a dynamic stage end on each of them but, perhaps, the last before its end.
double next_step_multiple(const Stage& stage, double stage_time);

}  // namespace rockslope::dda
