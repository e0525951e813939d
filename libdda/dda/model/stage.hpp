#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dda/base/indices.hpp"
#include "dda/joint/joint_types.hpp"
#include "dda/model/time_table.hpp"

namespace rockslope::dda {

enum class StageKind { static_equilibrium, dynamic };

/// Step size control and acceptance. The defaults are Shi's where he gives one [Shi 1993, ch. 4].
struct StepControl {
    double step = 0.005;          ///< s, the largest step
    double smallest_step = 1e-9;  ///< s; the run ends with the reason if a smaller step is needed
    double cut = 1.0 / 3.0;       ///< factor on the step after a rejection
    double growth = 1.3;          ///< factor on the step after a step that converged easily, up to `step`
    int iteration_limit = 100;    ///< open-close iterations in a step
    double displacement_ratio = 0.01;  ///< largest vertex displacement in a step over the model's half-height
    double force_tolerance =
        1e-6;  ///< largest change of a contact force over the reference force at convergence
};

/// Acceleration, m/s2, of the prescribed blocks named `block`, or of all prescribed blocks if `block` is
/// empty. It is zero outside the tables. Times count from the stage's start. Fixed blocks do not move.
struct BaseMotion {
    std::string block;
    TimeTable x;
    TimeTable y;
};

/// A search for the factor of safety, in place of a static stage.
struct StrengthReduction {
    double lowest = 0.1;            ///< smallest factor tried
    double highest = 10;            ///< largest factor tried
    double width = 0.01;            ///< of the final bracket: its larger factor over the smaller, less 1
    double displacement_limit = 0;  ///< m; the slope has failed if a block moves farther
};

/// An incident wave that enters through the viscous boundaries named `boundary`, or through all without a
/// free field if `boundary` is empty. Each component is the particle velocity of the upward wave alone, m/s,
/// or the traction that it exerts on the rock, Pa. Zero outside the tables. Times count from the stage's
/// start.
struct IncidentWave {
    std::string boundary;
    TimeTable x;
    TimeTable y;
    bool x_is_traction = false;
    bool y_is_traction = false;
};

/// A displacement at which a stage ends because the slope has come down. Displacements count from where
/// displacements were last zeroed, less that of the reference.
struct StopLimit {
    double displacement = 0;  ///< m
    double share = 0;  ///< of the mass of the free blocks, that blocks beyond it must exceed; not for a point
    std::string watched;                    ///< name of the point or region; empty: all free blocks
    PointIndex point = PointIndex::none();  ///< of a measured point; none: blocks are watched
    std::vector<BlockIndex> blocks;         ///< of a region; empty without a point: all free blocks
    PointIndex reference_point = PointIndex::none();
    BlockIndex reference_block = BlockIndex::none();
};

/// One part of a run.
struct Stage {
    std::string name;
    StageKind kind = StageKind::dynamic;
    double duration = 0;  ///< s, of a dynamic stage
    double dynamic_coefficient =
        1;                    ///< fraction of the velocity that passes to the next step; static stages: 0
    double tolerance = 1e-6;  ///< static: unbalanced force over weight at which the stage ends
    int step_limit = 20000;   ///< static: the stage has failed to settle after this many steps
    /// m, static: the stage has failed to settle when a block has moved farther in it
    double displacement_limit = std::numeric_limits<double>::infinity();
    /// Static: largest mass of the blocks that still move at the stage's end over the mass of all free
    /// blocks.
    double moving_share = 1e-4;
    bool remove_moving = false;  ///< static: the blocks that still move at its end are removed
    /// Static: bonds are judged where they hold at rest, Eq. (96). False: a bond breaks in the step
    /// in which it slips or its tension exceeds its strength.
    bool bonds_break_at_rest = false;
    double newmark_beta = 0.5;  ///< Newmark's parameters; (1/2, 1) is Shi's integration
    double newmark_gamma = 1.0;
    double mass_damping = 0;           ///< 1/s, mass-proportional damping
    bool reset_displacements = true;   ///< static: displacements and slips are zeroed at the stage's end
    bool reset_joint_history = false;  ///< static: joint histories are reset at the stage's end
    StepControl control;
    std::vector<BaseMotion> base_motions;
    /// Accelerations of the frame of reference, m/s2: the bases stay, and every block has the opposite body
    /// acceleration. Their `block` is not used.
    std::vector<BaseMotion> frame_motions;
    std::optional<StrengthReduction> strength_reduction;  ///< static: factor-of-safety search
    std::vector<IncidentWave> incident_waves;
    std::int64_t perturbation = 0;  ///< dynamic: seed of a perturbation of the order of rounding; 0: none
    std::optional<StopLimit> stop;  ///< the stage ends there, with the status `collapsed`

    /// Whether the stage seeks a state of rest: its steps have no inertia that is carried on, and no time.
    bool is_static() const { return kind == StageKind::static_equilibrium; }
    /// The time that one of its steps takes. @param dt s, size of the step.
    StepTime time_of_step(double dt) const { return is_static() ? StepTime() : StepTime(dt); }
};

/// The smallest multiple k * step, k = 1, 2, ..., after the given time, s since the stage's start. The steps
/// of a dynamic stage end at all multiples, except perhaps the last before the stage's end.
double next_step_multiple(const Stage& stage, double stage_time);

}  // namespace rockslope::dda
