#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// What lines enclose, with corners on the grid.
struct EnclosedArea {
    std::vector<Ring> outlines;  ///< counter-clockwise, of parts that share no edge; from left to right
    std::vector<std::optional<Ring>>
        faces;  ///< per given point: the innermost face that holds it, or nothing
};

/// Finds the area that lines enclose together, gaps within it included, and the faces that hold the points.
/// `step` is the grid's, m. A line file of Shi's programs gives its outline only so.
using EnclosedAreaFunction = std::function<EnclosedArea(std::span<const std::pair<Point, Point>> lines,
                                                        std::span<const Point> points, double step)>;

/// Reads and checks every table of a slope's model file, and the files it names.
/// @param enclosed_area the cutter's own, `blockgen::enclosed_area`, which lies above the input.
/// @throws InputError with file, line and key for anything unknown, missing, of the wrong type or out of
/// range.
SlopeModel read_slope_model(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area);

/// A commented model file with every key, ready to be edited.
std::string slope_model_template();

}  // namespace rockslope::blockgen
