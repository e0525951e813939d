#pragma once

#include <vector>

#include "common/geometry/axis_density.hpp"
#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// The lines of one density on the equal-area net of the unit circle.
struct DensityContour {
    double density = 0;  ///< % for each % of the area
    std::vector<std::vector<Point>> lines;
};

/// Contours of a density at round values up to its largest, ascending. The lowest is above that of uniform
/// axes, 1, by more than 2.5 of their standard deviations, so that chance hardly ever draws one.
std::vector<DensityContour> density_contours(const AxisDensity& density);

}  // namespace rockslope::blockgen
