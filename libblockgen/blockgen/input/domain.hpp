#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// The upright box round all parts of the domain.
Bounds domain_bounds(const SlopeModel& model);

/// Whether a point lies within the outline of a part of the domain, or on it. Holes are not looked at.
bool is_in_outlines(const SlopeModel& model, const Point& p);

/// Whether a ring has no area in common with any part of the domain.
bool is_outside_domain(const Ring& ring, const SlopeModel& model);

}  // namespace rockslope::blockgen
