#pragma once

#include <filesystem>
#include <vector>

#include "blockgen/input/map_file.hpp"
#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// The polygons of an outline file, in file order: for each, the outer ring and then its holes. The file is
/// CSV with the columns x,y and one corner a line, GeoJSON with Polygons, or a .dxf, .shp or .gpkg file read
/// by GDAL. A last corner that repeats the first is dropped. Coordinates are those of the file.
/// @throws InputError
std::vector<std::vector<Ring>> read_outline_file(const std::filesystem::path& path,
                                                 MapNotes* notes = nullptr);

/// Whether the name of a file is that of points and lines: .csv, .txt, .geojson, .json, .dxf, .shp, .gpkg.
bool is_geometry_file(const std::filesystem::path& path);
/// Whether the name of a file is that of a table: .csv or .txt.
bool is_csv_file(const std::filesystem::path& path);

/// Which columns of a table of lines are read beside x1,y1,x2,y2: joint_material, or also dip, dip_direction,
/// z1 and z2. Other formats always give all.
enum class LineFields { material, all };

/// The lines of a file as they are, possibly none: of the formats that read_trace_file() knows.
/// @throws InputError
MapLines read_line_file(const std::filesystem::path& path, LineFields fields = LineFields::material);

/// The joint material of a line: its own, or `fallback`, or the name of its layer. @throws InputError when it
/// has none of them.
const std::string& joint_material_of(const MapLine& line, const std::string& fallback,
                                     const std::filesystem::path& path);

/// The traces of a file. The file is CSV with the columns x1,y1,x2,y2 and optionally joint_material, GeoJSON
/// with LineStrings and MultiLineStrings (a feature's property joint_material names its material), or a file
/// read by GDAL. A trace without a material in the file gets `joint_material`; if that is empty and GDAL read
/// the file, it gets the name of its layer. Coordinates are those of the file. @throws InputError, also when
/// the file contains no trace.
std::vector<Trace> read_trace_file(const std::filesystem::path& path, const std::string& name,
                                   const std::string& joint_material, MapNotes* notes = nullptr);

/// The points of the one line of a file: CSV with the columns x,y and one point a line, or a file that
/// read_trace_file() reads. Coordinates are those of the file. @throws InputError, also when the file has no
/// line, or several.
std::vector<Point> read_single_line(const std::filesystem::path& path, MapNotes* notes = nullptr);

}  // namespace rockslope::blockgen
