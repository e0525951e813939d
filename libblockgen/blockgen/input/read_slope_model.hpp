#pragma once

#include "blockgen/config/config_table.hpp"
#include "blockgen/input/slope_model.hpp"

namespace blockgen {

/// Reads and checks every table of a slope's model file, and the files it names.
/// @throws InputError with file, line and key for anything unknown, missing, of the wrong type or out of
/// range.
SlopeModel read_slope_model(const ConfigTable& root);

/// A commented model file with every key, ready to be edited.
std::string slope_model_template();

}  // namespace blockgen
