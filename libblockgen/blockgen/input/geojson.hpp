#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

struct GeoJsonLine {
    std::string joint_material;  ///< from the feature's property of that name; may be empty
    std::vector<Point> points;
};

/// All LineStrings and MultiLineStrings of a GeoJSON file (RFC 7946), also those in features and collections.
/// Coordinates are planar, in metres; the file's reference system and third coordinates are ignored.
/// @throws InputError for a file that is not JSON or not GeoJSON.
std::vector<GeoJsonLine> read_geojson_lines(const std::filesystem::path& path);

/// The rings of each Polygon, and of each part of a MultiPolygon, of a GeoJSON file: the outer ring first.
/// The last point of a ring repeats its first point.
std::vector<std::vector<Ring>> read_geojson_polygons(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
