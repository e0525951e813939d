#include "dda/checkpoint/resume_check.hpp"

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "dda/hdf/vtkhdf_file.hpp"

namespace rockslope::dda {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
    throw InputError({file.string()}, "cannot be resumed from: " + what,
                     "the results as they were when the run was stopped");
}

void check_frames(const fs::path& file, std::int64_t count) {
    try {
        const VtkHdfReader frames(file);
        if (frames.frame_count() < count)
            fail(file, "it holds " + std::to_string(frames.frame_count()) + " frames, the checkpoint " +
                           std::to_string(count));
        for (std::int64_t k = 0; k < count; ++k) frames.frame(k, frames.column_names());
    } catch (const OutputError& error) {
        fail(file, error.what());
    }
}

void check_size(const fs::path& file, std::int64_t bytes) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error) fail(file, error.message());
    if (size < static_cast<std::uintmax_t>(bytes))
        fail(file, "it has " + std::to_string(size) + " bytes, the checkpoint " + std::to_string(bytes));
}

void check_frame_files(const fs::path& list, std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
        const fs::path file = list.parent_path() / frame_file_name(list.stem().string(), k);
        std::error_code error;
        if (!fs::is_regular_file(file, error)) fail(file, "it is not there");
    }
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

void check_resumable(const Checkpoint& checkpoint, const WriterContext& context) {
    for (const WriterEntry& entry : writer_table()) {
        const fs::path file = context.folder / result_file(entry, context.name);
        const auto position = checkpoint.positions.find(entry.name);
        const bool was_written = position != checkpoint.positions.end();
        if (was_written != entry.is_enabled(context))
            fail(file, was_written ? "the stopped run wrote it, but it is not requested now"
                                   : "the stopped run did not write it, but it is requested now");
        if (!was_written) continue;
        if (entry.unit == PositionUnit::frames) check_frames(file, position->second);
        if (entry.unit == PositionUnit::bytes) check_size(file, position->second);
        if (entry.unit == PositionUnit::files) check_frame_files(file, position->second);
    }
}

}  // namespace rockslope::dda
