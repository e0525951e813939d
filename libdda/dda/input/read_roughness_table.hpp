#pragma once

#include "common/config/config_table.hpp"
#include "dda/joint/barton.hpp"
#include "dda/joint/roughness_table.hpp"

namespace rockslope::dda {

/// The pairs [x, ratio] of a key. @throws InputError unless x starts at 0 or above and grows, and every ratio
/// is from -1 to 1.
RoughnessTable read_roughness_table(const ConfigTable& table, std::string_view key);

/// `residual_friction_angle`, `jrc` and `jcs`.
BartonStrength read_barton_strength(const ConfigTable& table);

/// `damage`: 0 for no dilation, or 1 to 2.
double read_damage(const ConfigTable& table);

}  // namespace rockslope::dda
