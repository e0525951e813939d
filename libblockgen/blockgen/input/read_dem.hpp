#pragma once

#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// The ground along the section line from a raster of elevations, the last of model.files, which
/// `profile_file` of [domain] names: distance and elevation, m, at equal steps of at most `profile_step`, by
/// default one cell. The raster is held to the rules of place_coordinates(); with model.project the section
/// line is converted to the raster's system, and the raster stays as it is. Elevations in a unit that the
/// raster states, or `unit` of the table, are converted.
/// @throws InputError for a section line that leaves the raster, a place without an elevation, and a system
/// or unit that is refused.
std::vector<Point> read_dem_profile(const ConfigTable& root, const ConfigTable& domain, SlopeModel& model);

}  // namespace rockslope::blockgen
