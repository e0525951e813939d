#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A line of a file that GDAL reads.
struct GdalLine {
    std::string joint_material;  ///< from the feature's field of that name; may be empty
    std::string layer;           ///< DXF: layer of the drawing; otherwise layer of the file
    std::vector<Point> points;
};

/// Whether this build includes GDAL.
bool has_gdal();

/// All lines of all layers, in the order of the file: line strings, rings of polygons, and curves as chains
/// of short segments. Points and texts are skipped. @throws InputError when the file cannot be read, its
/// coordinates are in degrees, or this build lacks GDAL.
std::vector<GdalLine> read_gdal_lines(const std::filesystem::path& path);

/// The rings of each polygon of the file, the outer ring first. A closed line counts as a polygon.
/// @throws InputError as read_gdal_lines(), and when the file has no polygon or an open line.
std::vector<std::vector<Ring>> read_gdal_polygons(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
