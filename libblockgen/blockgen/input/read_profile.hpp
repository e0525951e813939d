#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// Reads the profile of the ground that `profile_file` of [domain] names, and closes it below at `bottom`, or
/// `depth` below its lowest point. The file is CSV with the columns distance,elevation, or x,y, or x,y,z,
/// or one line of a map file. With third coordinates its points are on the map and are projected to the
/// section line; otherwise they are points of the section. Any other file is a raster for
/// read_dem_profile(). Coordinates are brought to metres.
/// @return the outline. @throws InputError for a profile that find_profile_fault() refuses, a line that does
/// not follow the section line, or a bottom that is not below the ground.
Ring read_profile(const ConfigTable& root, const ConfigTable& domain, SlopeModel& model);

}  // namespace rockslope::blockgen
