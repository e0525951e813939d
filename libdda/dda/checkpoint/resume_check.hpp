#pragma once

#include <string>
#include <vector>

#include "dda/checkpoint/checkpoint.hpp"
#include "dda/writers/result_writer.hpp"

namespace rockslope::dda {

/// The names of all files that a run may write into its folder, but for the frames of --pvd.
std::vector<std::string> result_files(const std::string& stem);

/// Proves, before any of them is touched, that the results in context.folder reach as far as the checkpoint
/// says and can be read up to there, and that the same kinds of results are asked for. @throws InputError
/// naming the file.
void check_resumable(const Checkpoint& checkpoint, const WriterContext& context);

}  // namespace rockslope::dda
