#pragma once

#include <filesystem>
#include <vector>

#include "blockgen/input/slope_model.hpp"

namespace rockslope::blockgen {

/// The parts of an outline file, of each the outer ring and then its holes: CSV with the columns x,y, one
/// corner a line, or GeoJSON with Polygons, or what GDAL reads by the extensions .dxf, .shp and .gpkg. A last
/// corner that repeats the first is dropped. In file order. @throws InputError
std::vector<std::vector<Ring>> read_outline_file(const std::filesystem::path& path);

/// The traces of a file: CSV with the columns x1,y1,x2,y2 and perhaps joint_material, or GeoJSON with
/// LineStrings and MultiLineStrings (a feature's property joint_material names its material), or what GDAL
/// reads. Traces without a material of their own get `joint_material`, and from GDAL's files, when that is
/// empty, the name of their layer. @throws InputError, also when the file holds no trace.
std::vector<Trace> read_trace_file(const std::filesystem::path& path, const std::string& name,
                                   const std::string& joint_material);

}  // namespace rockslope::blockgen
