#pragma once

#include <filesystem>
#include <vector>

#include "blockgen/input/map_file.hpp"
#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// The points of a file that is named by a key of a table.
struct PlacedFile {
    const ConfigTable& table;
    std::string key;
    std::filesystem::path path;
    MapNotes notes;
    std::vector<std::vector<Point>*> lines;
    std::vector<std::vector<double>*> heights = {};  ///< third coordinates, scaled with the points
    bool on_map = false;  ///< whether x and y are those of the map on which the section is a line
};

/// Puts the points of a file into the coordinates of the model, in metres. The file's system is `crs` of the
/// table, or the one that the file states; the unit of a drawing is `unit` of the table, or the one that it
/// states. With model.project the points are converted to that system; a file that states none is taken to be
/// in it. Otherwise the system must be in metres, and the same for all files. Adds a note to the model for
/// what was converted, and for geometries and heights that were not read.
/// @throws InputError for coordinates in degrees, feet or another system than an earlier file's, and for
/// coordinates that state nothing and look like degrees.
void place_coordinates(const PlacedFile& file, SlopeModel& model);

/// The system of a file: `crs` of the table, or the one that the file states, or degrees where its points
/// look like them; none when it is in metres of no system. @throws InputError as place_coordinates()
CoordinateSystem accepted_system(const PlacedFile& file, SlopeModel& model);

/// Puts the points of a file whose x and y are distance and elevation into metres: `unit` of the table, or
/// the unit that a drawing states. @throws InputError for a file that states a coordinate system of the map,
/// unless `crs` is "local".
void place_in_section(const PlacedFile& file, SlopeModel& model);

/// Reads `project` of [domain]. @throws InputError when it is unknown or not in metres.
void read_project(const ConfigTable& domain, SlopeModel& model);

}  // namespace rockslope::blockgen
