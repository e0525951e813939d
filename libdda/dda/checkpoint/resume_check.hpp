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

/// The digest of what a file has up to a position, as ResultWriter::digest() tells it. @throws OutputError
/// when it ends before, or cannot be read.
std::string digest_of(const WriterEntry& entry, const std::filesystem::path& file, std::int64_t position);

/// Checks that a file has, up to the position in the checkpoint, what was written there. @throws InputError
/// that names the file.
void check_digest(const Checkpoint& checkpoint, const WriterEntry& entry, const std::filesystem::path& file);

/// Checks, before any file is changed, that the results in context.folder are, up to the positions in the
/// checkpoint, those that were written, and that the same kinds of results are requested. @throws InputError
/// that names the file.
void check_resumable(const Checkpoint& checkpoint, const WriterContext& context);

}  // namespace rockslope::dda
