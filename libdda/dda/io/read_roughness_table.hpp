#pragma once

#include "blockgen/config/config_table.hpp"
#include "dda/joint/barton.hpp"
#include "dda/joint/roughness_table.hpp"

namespace dda {

/// The pairs [x, ratio] of a key. @throws InputError unless x starts at 0 or above and grows, and every ratio
/// is from -1 to 1.
RoughnessTable read_roughness_table(const blockgen::ConfigTable& table, std::string_view key);

/// `residual_friction_angle`, `jrc` and `jcs`.
BartonStrength read_barton_strength(const blockgen::ConfigTable& table);

/// `damage`: 0 for no dilation, or 1 to 2.
double read_damage(const blockgen::ConfigTable& table);

}  // namespace dda
