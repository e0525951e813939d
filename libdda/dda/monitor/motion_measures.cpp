#include "dda/monitor/motion_measures.hpp"

#include <cmath>
#include <optional>

namespace rockslope::dda {

namespace {

constexpr double spectral_damping = 0.05;
constexpr double evenness = 1e-6;  ///< of a time step over the mean

/// The table as an accelerogram; nothing for a motion of fewer than two instants, or of uneven ones.
std::optional<record::Accelerogram> accelerogram_of(const TimeTable& table) {
    const std::vector<double>& times = table.times();
    if (times.size() < 2 || record::largest_magnitude(table.values()) == 0) return std::nullopt;
    const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    for (std::size_t k = 1; k < times.size(); ++k)
        if (std::abs(times[k] - times[k - 1] - step) > evenness * step) return std::nullopt;
    return record::Accelerogram{step, table.values()};
}

void add(const Stage& stage, const BaseMotion& motion, std::vector<MotionMeasures>& list) {
    for (const char axis : {'x', 'y'}) {
        const auto accelerogram = accelerogram_of(axis == 'x' ? motion.x : motion.y);
        if (!accelerogram) continue;
        list.push_back({stage.name, motion.block, axis, record::measure(*accelerogram),
                        record::response_spectrum(*accelerogram, spectral_periods, spectral_damping)});
    }
}

}  // namespace

std::vector<MotionMeasures> motion_measures(const std::vector<Stage>& stages) {
    std::vector<MotionMeasures> list;
    for (const Stage& stage : stages) {
        for (const BaseMotion& motion : stage.base_motions) add(stage, motion, list);
        for (const BaseMotion& motion : stage.frame_motions) add(stage, motion, list);
    }
    return list;
}

}  // namespace rockslope::dda
