#include "dda/monitor/region_motion.hpp"

#include <algorithm>

namespace rockslope::dda {

RegionDisplacement displacement_of(const State& state, const MeasuredRegion& region, const Vec2& reference) {
    RegionDisplacement displacement;
    double area = 0;
    for (const BlockIndex block : region.blocks) {
        if (!state.is_present(block)) continue;
        const double distance =
            (state.blocks.centroid(block) - state.centroid_origin[block] - reference).norm();
        displacement.largest = std::max(displacement.largest, distance);
        displacement.mean += state.blocks.moments[block].area * distance;
        area += state.blocks.moments[block].area;
    }
    if (area > 0) displacement.mean /= area;
    return displacement;
}

void RegionPeaks::add(const RegionDisplacement& now, double time) {
    if (now.mean > mean) {
        mean = now.mean;
        mean_time = time;
    }
    if (now.largest > largest) {
        largest = now.largest;
        largest_time = time;
    }
}

}  // namespace rockslope::dda
