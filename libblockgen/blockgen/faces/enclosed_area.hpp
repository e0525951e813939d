#pragma once

#include "blockgen/input/read_slope_model.hpp"

namespace rockslope::blockgen {

/// The area enclosed by lines, from their noding and arrangement: an EnclosedAreaFunction.
EnclosedArea enclosed_area(std::span<const std::pair<Point, Point>> lines, std::span<const Point> points,
                           double step);

}  // namespace rockslope::blockgen
