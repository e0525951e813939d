#include "dda/checkpoint/resume_check.hpp"

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"
#include "common/base/sha256.hpp"
#include "dda/hdf/vtkhdf_file.hpp"

namespace rockslope::dda {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
    throw InputError({file.string()}, "cannot be resumed from: " + what,
                     "the results as they were when the run was stopped");
}

/// @throws OutputError if there are fewer frames.
std::string digest_of_frames(const fs::path& file, std::int64_t count) {
    const VtkHdfReader frames(file);
    if (frames.frame_count() < count)
        throw OutputError(file, "it holds " + std::to_string(frames.frame_count()) +
                                    " frames, the checkpoint " + std::to_string(count));
    return frames.digest(count);
}

/// @throws OutputError if there are fewer bytes.
std::string digest_of_bytes(const fs::path& file, std::int64_t bytes) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error) throw OutputError(file, error.message());
    if (size < static_cast<std::uintmax_t>(bytes))
        throw OutputError(
            file, "it has " + std::to_string(size) + " bytes, the checkpoint " + std::to_string(bytes));
    return sha256_of_beginning(file, static_cast<std::uintmax_t>(bytes)).digest();
}

/// @throws OutputError if one of the files is not there.
std::string digest_of_files(const fs::path& list, std::int64_t count) {
    Sha256 digest;
    for (std::int64_t k = 0; k < count; ++k) {
        const fs::path file = list.parent_path() / frame_file_name(list.stem().string(), k);
        std::error_code error;
        if (!fs::is_regular_file(file, error)) throw OutputError(file, "it is not there");
        digest.add(read_text_file(file));
    }
    return digest.digest();
}

}  // namespace

std::string result_file(const WriterEntry& entry, const std::string& stem) {
    const std::string file = entry.file;
    return file.front() == '*' ? stem + file.substr(1) : file;
}

std::vector<std::string> result_files(const std::string& stem) {
    std::vector<std::string> files = {"run.toml", "summary.json", "failed.json", "checkpoint.h5",
                                      "blocks.csv"};
    for (const WriterEntry& entry : writer_table()) files.push_back(result_file(entry, stem));
    return files;
}

std::string digest_of(const WriterEntry& entry, const fs::path& file, std::int64_t position) {
    switch (entry.unit) {
        case PositionUnit::frames:
            return digest_of_frames(file, position);
        case PositionUnit::bytes:
            return digest_of_bytes(file, position);
        default:
            return digest_of_files(file, position);
    }
}

void check_digest(const Checkpoint& checkpoint, const WriterEntry& entry, const fs::path& file) {
    try {
        const std::string found = digest_of(entry, file, checkpoint.positions.at(entry.name));
        const auto written = checkpoint.digests.find(entry.name);
        if (written != checkpoint.digests.end() && written->second != found) fail(file, "it is damaged");
    } catch (const OutputError& error) {
        fail(file, error.what());
    }
}

void check_resumable(const Checkpoint& checkpoint, const WriterContext& context) {
    for (const WriterEntry& entry : writer_table()) {
        const fs::path file = context.folder / result_file(entry, context.name);
        const auto position = checkpoint.positions.find(entry.name);
        const bool was_written = position != checkpoint.positions.end();
        if (was_written != entry.is_enabled(context))
            fail(file, was_written ? "the stopped run wrote it, but it is not requested now"
                                   : "the stopped run did not write it, but it is requested now");
        if (was_written) check_digest(checkpoint, entry, file);
    }
}

}  // namespace rockslope::dda
