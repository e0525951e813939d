#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

struct GeoJsonLine {
    std::string joint_material;  ///< the feature's property of that name; empty when it has none
    std::vector<Point> points;
};

/// All LineStrings and MultiLineStrings of a GeoJSON file (RFC 7946), bare, in features or in collections.
/// Coordinates are taken as planar metres, whatever reference system the file names; a third coordinate is
/// ignored.
/// @throws InputError for a file that is no JSON or no GeoJSON.
std::vector<GeoJsonLine> read_geojson_lines(const std::filesystem::path& path);

/// The Polygons and the parts of MultiPolygons of a GeoJSON file: the rings of each, outer ring first,
/// closing corner included.
std::vector<std::vector<Ring>> read_geojson_polygons(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
