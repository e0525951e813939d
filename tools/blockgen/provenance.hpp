#pragma once

#include <string>
#include <vector>

#include "blockgen/input/slope_model.hpp"
#include "common/base/read_log.hpp"
#include "common/config/config_table.hpp"
#include "options.hpp"

namespace rockslope::blockgen_tool {

/// Program version, seed, and the beginning of a SHA-256 digest of the effective model and of every file it
/// names, as read. @param log of this thread, since before the model was read.
std::vector<std::string> provenance(const blockgen::SlopeModel& model, const ConfigTable& config,
                                    const ReadLog& log);

/// A Make rule: the block file depends on the model file and the files it names.
std::string make_rule(const Options& options, const blockgen::SlopeModel& model);

/// Checks the output files before the cut. @throws InputError when a result cannot be written, when two
/// results have the same name, or when one would overwrite a file from which the model is read.
void check_outputs(const Options& options, const blockgen::SlopeModel& model);

}  // namespace rockslope::blockgen_tool
