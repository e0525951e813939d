#include "record/accelerogram.hpp"

#include <algorithm>
#include <cmath>

namespace rockslope::record {

GroundMotion integrate(const Accelerogram& record) {
    const std::size_t count = record.values.size();
    GroundMotion motion{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0)};
    const double dt = record.step;
    for (std::size_t k = 1; k < count; ++k) {
        const double before = record.values[k - 1];
        const double after = record.values[k];
        motion.velocity[k] = motion.velocity[k - 1] + dt * (before + after) / 2;
        motion.displacement[k] =
            motion.displacement[k - 1] + dt * motion.velocity[k - 1] + dt * dt * (2 * before + after) / 6;
    }
    return motion;
}

double largest_magnitude(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    return largest;
}

}  // namespace rockslope::record
