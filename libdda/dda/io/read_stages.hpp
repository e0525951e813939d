#pragma once

#include <vector>

#include "blockgen/config/config_table.hpp"
#include "dda/io/read_loads.hpp"
#include "dda/model/model.hpp"
#include "dda/model/stage.hpp"

namespace dda {

/// The [[stage]] tables. A key that the stage's kind does not use is an unknown key.
/// @throws InputError also for a base motion of a block that the model does not have, and for a bad record.
std::vector<Stage> read_stages(const blockgen::ConfigTable& run, const Model& model, InputFiles& files);

}  // namespace dda
