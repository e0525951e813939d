#pragma once

#include <string>

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// Reads a line across the section, from `key` or from the file that `key`_file names, in the coordinates of
/// the model: one point or more from left to right, x never decreasing, no point twice in a row.
/// @param expected what to write instead of a line that turns back, for the message.
/// @throws InputError also for a line beside the domain.
std::vector<Point> read_line_across(const ConfigTable& table, const std::string& key,
                                    const std::string& expected, SlopeModel& model);

/// Adds a region to the model. @throws InputError at `name` when there is one of that name already.
void add_region(const ConfigTable& table, Region region, SlopeModel& model);

/// [[layer]]: each becomes a region, from its top down to the next layer's top, the last one down to the
/// bottom of the domain. A top that lies higher than that of a layer before is cut off there.
void read_layers(const ConfigTable& root, SlopeModel& model);

/// [weathered] or [[weathered]]: each zone becomes a region, from the ground surface, or from the base of the
/// next shallower zone, down to its vertical depth below the surface.
void read_weathered_zones(const ConfigTable& root, SlopeModel& model);

/// [water_table]: the head line of still water in the rock.
void read_water_table(const ConfigTable& root, SlopeModel& model);

}  // namespace rockslope::blockgen
