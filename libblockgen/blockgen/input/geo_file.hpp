#pragma once

#include <filesystem>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A line of Shi's geometry file; `number` is a material's.
struct GeoLine {
    Point a, b;
    int number = 1;
};

/// The lines and points that Shi's program for cutting blocks reads (Shi 1993, DDA user's manual; read here
/// as its open descendants do): the least distance of a node from an edge; the number of joint lines and how
/// many of them bound the model; the numbers of material lines, bolts, fixed lines, loaded, measured and hole
/// points; then all of these in turn.
struct GeoFile {
    double edge_node_distance = 0;        ///< m
    std::vector<GeoLine> joints;          ///< x1 y1 x2 y2 joint material
    std::vector<GeoLine> material_lines;  ///< x1 y1 x2 y2 block material, of the blocks that they run through
    std::vector<GeoLine> bolts;  ///< x1 y1 x2 y2 stiffness, strength, preload; the last three are not kept
    std::vector<GeoLine> fixed_lines;  ///< x1 y1 x2 y2
    std::vector<Point> loaded_points, measured_points, hole_points;
};

/// @throws InputError with line and column for a word that is no number, a count that the file does not hold,
/// or words after the end.
GeoFile read_geo_file(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
