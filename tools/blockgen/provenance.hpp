#pragma once

#include <string>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/config/config_table.hpp"
#include "options.hpp"

namespace rockslope::blockgen_tool {

/// Program version, seed, and a hash of the effective model and of every file it names.
std::vector<std::string> provenance(const blockgen::SlopeModel& model, const ConfigTable& config);

/// A Make rule: the block file depends on the model file and the files it names.
std::string make_rule(const Options& options, const blockgen::SlopeModel& model);

/// Before any work is done: @throws InputError when a result cannot be written, when two have one name, or
/// when one would overwrite a file that the model is read from.
void check_outputs(const Options& options, const blockgen::SlopeModel& model);

}  // namespace rockslope::blockgen_tool
