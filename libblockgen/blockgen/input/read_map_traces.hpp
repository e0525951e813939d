#pragma once

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

/// Reads a table [[traces]] whose traces are on the map, and adds to the model the joints in which their
/// planes cut the section: straight lines at the apparent dip through the ground where the trace meets the
/// section line. Traces that do not meet it are counted in a note. @param name, @param joint_material of the
/// table, which may be empty. @throws InputError, also when no trace meets the section.
void read_map_traces(const ConfigTable& root, const ConfigTable& table, const std::string& name,
                     const std::string& joint_material, SlopeModel& model);

}  // namespace rockslope::blockgen
