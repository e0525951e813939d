#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// A line of a file that GDAL reads.
struct GdalLine {
    std::string joint_material;  ///< of the feature's field of that name; may be empty
    std::string layer;           ///< DXF: the drawing's layer; otherwise that of the file
    std::vector<Point> points;
};

/// Whether this build can read such files.
bool has_gdal();

/// All lines of all layers, in the order of the file: line strings, rings of polygons, and curves as chains
/// of short segments. Points and texts are passed over. @throws InputError when the file cannot be read, its
/// coordinates are degrees, or this build lacks GDAL.
std::vector<GdalLine> read_gdal_lines(const std::filesystem::path& path);

/// The rings of each of the file's polygons, the outer one first. A closed line is a polygon.
/// @throws InputError as above, and when there are none, or an open line.
std::vector<std::vector<Ring>> read_gdal_polygons(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
