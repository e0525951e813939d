#pragma once

#include <vector>

#include "common/config/config_table.hpp"
#include "dda/input/read_loads.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace rockslope::dda {

/// The [[stage]] tables. A key that the stage's kind does not use is an unknown key.
/// @throws InputError also for a base motion of a block that the model does not have, and for a bad record.
std::vector<Stage> read_stages(const ConfigTable& run, const Model& model, InputFiles& files);

}  // namespace rockslope::dda
