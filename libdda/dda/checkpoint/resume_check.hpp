#pragma once

#include <string>
#include <vector>

#include "dda/checkpoint/checkpoint.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

/// Name of the file of a writer, for results with this stem.
std::string result_file(const WriterEntry& entry, const std::string& stem);

/// Names of all files that a run may write into its folder, except the frames of --pvd.
std::vector<std::string> result_files(const std::string& stem);

/// Checks, before any file is changed, that the results in context.folder are readable up to the positions in
/// the checkpoint, and that the same kinds of results are requested. @throws InputError that names the file.
void check_resumable(const Checkpoint& checkpoint, const WriterContext& context);

}  // namespace rockslope::dda
