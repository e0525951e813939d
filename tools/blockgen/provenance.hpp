#pragma once

#include <string>
#include <vector>

#include "blockgen/config/config_table.hpp"
#include "blockgen/input/slope_model.hpp"
#include "options.hpp"

namespace blockgen_tool {

/// Program version, seed, and a hash of the effective model and of every file it names.
std::vector<std::string> provenance(const blockgen::SlopeModel& model, const blockgen::ConfigTable& config);

/// A Make rule: the block file depends on the model file and the files it names.
std::string make_rule(const Options& options, const blockgen::SlopeModel& model);

/// @throws OutputError when the folder of a result does not exist or cannot be written, before any work is
/// done.
void check_writable(const Options& options);

}  // namespace blockgen_tool
