#include "dda/analysis/base_motion.hpp"

namespace rockslope::dda {

namespace {

double acceleration_at(const TimeTable& table, double time) {
    if (table.empty() || time < table.times().front() || time > table.times().back()) return 0;
    return table.at(time);
}

}  // namespace

Vec2 base_acceleration(const Model& model, const Stage& stage, BlockIndex block, double stage_time) {
    Vec2 sum = Vec2::Zero();
    if (stage.is_static() || model.motion[block] != Motion::prescribed) return sum;
    for (const BaseMotion& base : stage.base_motions) {
        if (!base.block.empty() && base.block != model.block_name[block]) continue;
        sum += Vec2(acceleration_at(base.x, stage_time), acceleration_at(base.y, stage_time));
    }
    return sum;
}

Vec2 frame_acceleration(const Stage& stage, double stage_time) {
    Vec2 sum = Vec2::Zero();
    if (stage.is_static()) return sum;
    for (const BaseMotion& frame : stage.frame_motions)
        sum += Vec2(acceleration_at(frame.x, stage_time), acceleration_at(frame.y, stage_time));
    return sum;
}

Vec2 frame_acceleration_over_step(const Stage& stage, double dt, double stage_time) {
    return frame_acceleration(stage, next_step_multiple(stage, stage_time - dt / 2));
}

PrescribedMotion prescribe_motion(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                  double dt, double stage_time) {
    const PerBlock<Vec6> zero(model.block_count(), Vec6::Zero());
    PrescribedMotion motion{zero, zero, zero};
    if (stage.is_static()) return motion;
    const double later = next_step_multiple(stage, stage_time - dt / 2);
    for (const BlockIndex b : model.blocks()) {
        if (model.motion[b] != Motion::prescribed) continue;
        Vec6 step_acceleration = Vec6::Zero();
        step_acceleration.head<2>() = base_acceleration(model, stage, b, later);
        motion.acceleration[b].head<2>() = base_acceleration(model, stage, b, stage_time);
        // The step of a prescribed block, Eq. (40).
        motion.displacement[b] = dt * blocks.velocity[b] + dt * dt / 2 * step_acceleration;
        motion.velocity_change[b] = dt * step_acceleration;
    }
    return motion;
}

}  // namespace rockslope::dda
