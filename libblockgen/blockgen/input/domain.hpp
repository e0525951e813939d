#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/geometry/clip_line.hpp"

namespace rockslope::blockgen {

/// The axis-aligned bounding box of all parts of the domain.
Bounds domain_bounds(const SlopeModel& model);

/// Whether a point lies inside or on the outline of a part of the domain. Holes are ignored.
bool is_in_outlines(const SlopeModel& model, const Point& p);

/// The elevation of the ground at an x of the section: the highest point of the outlines there. Nothing where
/// they have none.
std::optional<double> ground_elevation(const SlopeModel& model, double x);

/// The name by which files state the coordinate system of the blocks: that of `project`, or of the files that
/// were read. Empty when none is known, and when the section is a vertical plane on the map, whose x and y
/// are coordinates of no system.
std::string system_urn(const SlopeModel& model);

}  // namespace rockslope::blockgen
