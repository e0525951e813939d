#pragma once

#include "blockgen/input/height_line.hpp"
#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// The ground surface: the highest point of the domain's outlines at each x, from its left end to its right
/// one. Overhangs and upright walls make steps. Where no part of the domain lies, between two parts, it is
/// the lower side of the domain's bounding box.
HeightLine ground_surface(const SlopeModel& model);

}  // namespace rockslope::blockgen
