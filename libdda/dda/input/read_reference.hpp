#pragma once

#include <string>

#include "common/config/config_table.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The key `relative_to`: the name of the measured point or prescribed block whose motion is subtracted in
/// relative motions. Default: the first prescribed block; empty without one.
/// @throws InputError for an unknown name.
std::string read_reference(const ConfigTable& table, const Model& model);

}  // namespace rockslope::dda
