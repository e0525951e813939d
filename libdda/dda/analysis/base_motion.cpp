#include "dda/analysis/base_motion.hpp"

namespace dda {

namespace {

double acceleration_at(const TimeTable& table, double time) {
    if (table.empty() || time < table.times().front() || time > table.times().back()) return 0;
    return table.at(time);
}

Vec6 acceleration_at(const BaseMotion& base, double time) {
    Vec6 a = Vec6::Zero();
    a[0] = acceleration_at(base.x, time);
    a[1] = acceleration_at(base.y, time);
    return a;
}

}  // namespace

PrescribedMotion prescribe_motion(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                  double dt, double stage_time) {
    const auto count = static_cast<std::size_t>(model.block_count());
    const std::vector<Vec6> zero(count, Vec6::Zero());
    PrescribedMotion motion{zero, zero, zero};
    if (stage.kind != StageKind::dynamic) return motion;
    const double later = next_instant(stage, stage_time - dt / 2);
    for (std::size_t b = 0; b < count; ++b) {
        if (model.motion[b] != Motion::prescribed) continue;
        Vec6 held = Vec6::Zero();
        for (const BaseMotion& base : stage.base_motions) {
            if (!base.block.empty() && base.block != model.block_name[b]) continue;
            held += acceleration_at(base, later);
            motion.acceleration[b] += acceleration_at(base, stage_time);
        }
        motion.displacement[b] = dt * blocks.velocity[b] + dt * dt / 2 * held;
        motion.velocity_change[b] = dt * held;
    }
    return motion;
}

}  // namespace dda
