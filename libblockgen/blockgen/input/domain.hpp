#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// The axis-aligned bounding box of all parts of the domain.
Bounds domain_bounds(const SlopeModel& model);

/// Whether a point lies inside or on the outline of a part of the domain. Holes are ignored.
bool is_in_outlines(const SlopeModel& model, const Point& p);

}  // namespace rockslope::blockgen
