#pragma once

#include <vector>

#include "common/config/config_table.hpp"
#include "dda/input/read_mesh.hpp"

namespace rockslope::dda {

/// Reads the tables [block_material.NAME], in the order of the file. @throws InputError for a value out of
/// range, or if there is no table.
std::vector<BlockMaterial> read_block_materials(const ConfigTable& run);

/// Reads the tables [joint_material.NAME], each with its joint law.
std::vector<JointMaterial> read_joint_materials(const ConfigTable& run);

/// Reads the tables [bolt_material.NAME], if any.
std::vector<BoltMaterial> read_bolt_materials(const ConfigTable& run);

/// Reads a number that must be positive, or not negative. An absent key gives the fallback, unchecked.
double positive(const ConfigTable& table, std::string_view key, Dimension dimension);
double positive(const ConfigTable& table, std::string_view key, Dimension dimension, double fallback);
double not_negative(const ConfigTable& table, std::string_view key, Dimension dimension, double fallback);

}  // namespace rockslope::dda
