#pragma once

#include "blockgen/input/read_slope_model.hpp"
#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"

namespace rockslope::blockgen {

Point point_of(const std::array<double, 2>& pair);

/// Reads a string. @throws InputError when it is empty.
std::string read_name(const ConfigTable& table, std::string_view key);

/// Reads a simple ring of at least three corners; turns it counter-clockwise. @throws InputError
Ring read_ring(const ConfigTable& table, std::string_view key);

/// @throws InputError at `key` when the outline and these points exceed the range of the cutter's integers:
/// coordinates of 2^51 grid steps, or an extent of 2^37 grid steps.
void check_coordinate_range(const ConfigTable& table, std::string_view key, const Ring& points,
                            const SlopeModel& model);

/// Reads [base]. Parts of the domain must share edges; the base lies along the outline of all together.
void read_base(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area, SlopeModel& model);

/// [domain]: outline, holes, block material, grid, policies; and the files it names.
void read_domain(const ConfigTable& root, const EnclosedAreaFunction& enclosed_area, SlopeModel& model);
/// domain.geo_file: all records of a geometry file of Shi's. The grid must have been read.
void read_geo_domain(const ConfigTable& domain, const EnclosedAreaFunction& enclosed_area, SlopeModel& model);
/// [[region]]
void read_regions(const ConfigTable& root, SlopeModel& model);
/// [[tunnel]] and [[excavation]]
void read_tunnels(const ConfigTable& root, SlopeModel& model);
/// [[joint_set]] and [[traces]]
void read_joints(const ConfigTable& root, SlopeModel& model);
/// [[joint_set]], and [section] for sets given as planes in space.
void read_joint_sets(const ConfigTable& root, SlopeModel& model);
/// [[fixed_block]], [[prescribed_block]], [kinematics], [[measured_point]] and [[bolt]]
void read_block_assignments(const ConfigTable& root, SlopeModel& model);

}  // namespace rockslope::blockgen
