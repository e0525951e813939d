#pragma once

#include <vector>

#include "common/config/config_table.hpp"
#include "dda/input/read_mesh.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The tables [block_material.NAME], in the order of the file. @throws InputError for a value out of range,
/// or no table at all.
std::vector<BlockMaterial> read_block_materials(const ConfigTable& run);

/// The tables [joint_material.NAME]; each names its law.
std::vector<JointMaterial> read_joint_materials(const ConfigTable& run);

/// The tables [bolt_material.NAME]; there may be none.
std::vector<BoltMaterial> read_bolt_materials(const ConfigTable& run);

/// Numbers with the ranges that most keys share. Absent keys take the fallback, which is not checked.
double positive(const ConfigTable& table, std::string_view key, Dimension dimension);
double positive(const ConfigTable& table, std::string_view key, Dimension dimension, double fallback);
double not_negative(const ConfigTable& table, std::string_view key, Dimension dimension, double fallback);

}  // namespace rockslope::dda
