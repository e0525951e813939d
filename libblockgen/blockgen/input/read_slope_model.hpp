#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// The area enclosed by lines, with corners on the grid.
struct EnclosedArea {
    std::vector<Ring> outlines;  ///< of the parts that share no edge; counter-clockwise, from left to right
    std::vector<std::optional<Ring>>
        faces;  ///< per given point: the innermost face that contains it, or nothing
};

/// Computes the outline of the area enclosed by lines, and the faces that contain given points. `step` is the
/// grid step, m. It is needed for geometry files of Shi's programs, which have no explicit outline.
using EnclosedAreaFunction = std::function<EnclosedArea(std::span<const std::pair<Point, Point>> lines,
                                                        std::span<const Point> points, double step)>;

/// Reads and checks all tables of a slope's model file, and the files it names.
/// @param enclosed_area usually `blockgen::enclosed_area`, which is passed in because the input floor may not
/// include the floors above it.
/// @throws InputError with file, line and key for a key or value that is unknown, missing, of the wrong type
/// or out of range.
SlopeModel read_slope_model(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area);

/// A commented model file with all keys, ready to be edited.
std::string slope_model_template();

}  // namespace rockslope::blockgen
