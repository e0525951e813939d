#pragma once

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// How far the blocks of a region have moved, m.
struct RegionDisplacement {
    double mean = 0;     ///< of the blocks' distances, by area
    double largest = 0;  ///< of a block
};

/// The displacement of the centroids of the blocks of a region that are present, less `reference`, m.
RegionDisplacement displacement_of(const State& state, const MeasuredRegion& region, const Vec2& reference);

/// Peak displacements of a region so far, with their times.
struct RegionPeaks {
    double mean = 0, mean_time = 0;        ///< m, s
    double largest = 0, largest_time = 0;  ///< m, s

    /// Takes the displacements of an instant, s, where they are larger.
    void add(const RegionDisplacement& now, double time);
};

}  // namespace rockslope::dda
