#pragma once

#include <filesystem>

#include "blockgen/input/map_file.hpp"

namespace rockslope::blockgen {

/// All LineStrings and MultiLineStrings of a GeoJSON file (RFC 7946), also those in features and collections.
/// The member `crs` of earlier versions of the format states the coordinate system. Geometries with third
/// coordinates are counted, geometries without a point counted and skipped. The file is read in one pass, in
/// time and memory linear in its size. @throws InputError for a file that is not JSON or not GeoJSON.
MapLines read_geojson_lines(const std::filesystem::path& path);

/// The rings of each Polygon, and of each part of a MultiPolygon, of a GeoJSON file: the outer ring first.
/// The last point of a ring repeats its first point.
MapPolygons read_geojson_polygons(const std::filesystem::path& path);

/// Lines and polygons of a GeoJSON file that may have both, such as a map of joints with its outline.
struct GeoJsonMap {
    MapLines lines;
    MapPolygons polygons;
};

/// As read_geojson_lines() and read_geojson_polygons() in one; either list may be empty.
GeoJsonMap read_geojson_map(const std::filesystem::path& path);

}  // namespace rockslope::blockgen
