#pragma once

#include "blockgen/config/config_table.hpp"
#include "blockgen/input/slope_model.hpp"

namespace blockgen {

Point point_of(const std::array<double, 2>& pair);

/// A simple ring of at least three corners under `key`; made counter-clockwise.
Ring read_ring(const ConfigTable& table, std::string_view key);

/// [domain]: outline, holes, block material, grid, policies; and the files it names.
void read_domain(const ConfigTable& root, SlopeModel& model);
/// [[region]]
void read_regions(const ConfigTable& root, SlopeModel& model);
/// [[tunnel]]
void read_tunnels(const ConfigTable& root, SlopeModel& model);
/// [[joint_set]] and [[traces]]
void read_joints(const ConfigTable& root, SlopeModel& model);
/// [[fixed_block]], [[prescribed_block]], [[measured_point]] and [[bolt]]
void read_marks(const ConfigTable& root, SlopeModel& model);

}  // namespace blockgen
