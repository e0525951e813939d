#pragma once

#include <filesystem>

#include "blockgen/input/map_file.hpp"

namespace rockslope::blockgen {

/// All lines of all layers, in the order of the file: line strings, rings of polygons, and curves as chains
/// of short segments. Points and texts are skipped. @throws InputError when the file cannot be read.
MapLines read_gdal_lines(const std::filesystem::path& path);

/// The polygons of the file. Lines make polygons where they are closed, or where they form closed chains; a
/// closed line inside another one is its inner ring. @throws InputError as read_gdal_lines(), and when the
/// file has no polygon or a line that is part of no closed chain.
MapPolygons read_gdal_polygons(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
