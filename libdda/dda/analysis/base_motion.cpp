#include "dda/analysis/base_motion.hpp"

namespace dda {

namespace {

double acceleration_at(const TimeTable& table, double time) {
    if (table.empty() || time < table.times().front() || time > table.times().back()) return 0;
    return table.at(time);
}

}  // namespace

PrescribedMotion prescribe_motion(const Model& model, const Stage& stage, const BlockSystem& blocks,
                                  double dt, double stage_time) {
    const auto count = static_cast<std::size_t>(model.block_count());
    PrescribedMotion motion{std::vector<Vec6>(count, Vec6::Zero()), std::vector<Vec6>(count, Vec6::Zero())};
    if (stage.kind != StageKind::dynamic) return motion;
    for (std::size_t b = 0; b < count; ++b) {
        if (model.motion[b] != Motion::prescribed) continue;
        for (const BaseMotion& base : stage.base_motions) {
            if (!base.block.empty() && base.block != model.block_name[b]) continue;
            motion.acceleration[b][0] += acceleration_at(base.x, stage_time);
            motion.acceleration[b][1] += acceleration_at(base.y, stage_time);
        }
        motion.displacement[b] = dt * blocks.velocity[b] + dt * dt / 2 * motion.acceleration[b];
    }
    return motion;
}

}  // namespace dda
