#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/geometry/clip_line.hpp"
#include "common/geometry/vertical_sections.hpp"

namespace rockslope::blockgen {

/// The axis-aligned bounding box of all parts of the domain.
Bounds domain_bounds(const SlopeModel& model);

/// Whether a point lies inside or on the outline of a part of the domain. Holes are ignored.
bool is_in_outlines(const SlopeModel& model, const Point& p);

/// Vertical lines through the outlines: the top of the one at an x is the elevation of the ground there.
VerticalSections outline_sections(const SlopeModel& model);

/// The name by which files state the coordinate system of the blocks: that of `project`, or of the files that
/// were read. Empty when none is known, and when the section is a vertical plane on the map, whose x and y
/// are coordinates of no system.
std::string system_urn(const SlopeModel& model);

}  // namespace rockslope::blockgen
