#pragma once

#include <filesystem>
#include <vector>

#include "common/geometry/point.hpp"

namespace rockslope::blockgen {

/// A line of Shi's geometry file; `number` is its material number.
struct GeoLine {
    Point a, b;
    int number = 1;
};

/// The contents of a geometry file of Shi's block-cutting program (Shi 1993, DDA user's manual), in the
/// variant of its open-source descendants. The file has: the least distance of a node from an edge; the
/// number of joint lines, and how many of them bound the model; the numbers of material lines, bolts, fixed
/// lines, loaded points, measured points and hole points; then the records in the same order.
struct GeoFile {
    double edge_node_distance = 0;        ///< m
    std::vector<GeoLine> joints;          ///< x1 y1 x2 y2 joint material
    std::vector<GeoLine> material_lines;  ///< x1 y1 x2 y2 material, of the blocks along the line
    std::vector<GeoLine> bolts;  ///< x1 y1 x2 y2 stiffness strength preload; the last three are discarded
    std::vector<GeoLine> fixed_lines;  ///< x1 y1 x2 y2
    std::vector<Point> loaded_points, measured_points, hole_points;
};

/// @throws InputError with line and column for a word that is not a number, a count larger than the number of
/// records, or words after the last record.
GeoFile read_geo_file(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
