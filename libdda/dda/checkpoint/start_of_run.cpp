#include "dda/checkpoint/start_of_run.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "common/base/input_error.hpp"
#include "common/base/output_error.hpp"
#include "dda/checkpoint/resume_check.hpp"

namespace rockslope::dda {

namespace fs = std::filesystem;

namespace {

/// One table of a fingerprint: its heading, "" for the first, and its lines.
struct Section {
    std::string heading;
    std::vector<std::string> lines;
};

std::vector<Section> sections_of(const std::string& text) {
    std::vector<Section> sections(1);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (line.starts_with('['))
            sections.push_back({line, {}});
        else if (!line.empty())
            sections.back().lines.push_back(line);
        begin = end + 1;
    }
    return sections;
}

bool is_of(const Section& section, const std::string& table) {
    const std::string_view name =
        std::string_view(section.heading)
            .substr(std::min(section.heading.find_first_not_of('['), section.heading.size()));
    return name.starts_with(table) && name.size() > table.size() &&
           (name[table.size()] == ']' || name[table.size()] == '.');
}

/// The lines of [output] that states depend on: relative displacements and slips so far are counted by them.
bool shapes_state(const std::string& line) {
    return line.starts_with("relative_to = ") || line.starts_with("slip_threshold = ");
}

std::string described(const Section& section) {
    return section.heading.empty() ? "the model" : section.heading;
}

std::string difference(const Section& section, const std::string& line, const std::string& saved) {
    if (line.starts_with("blocks = ") && saved.starts_with("blocks = "))
        return "the block file is not that of the saved run";
    return described(section) + " has " + (line.empty() ? "one line less" : "'" + line + "'") +
           ", the saved run has " + (saved.empty() ? "one line less" : "'" + saved + "'");
}

/// The files of a writer up to a position. The list of frames that are files of their own is left out: the
/// next frame writes it again.
std::vector<std::string> files_up_to(const WriterEntry& entry, const std::string& name,
                                     std::int64_t position) {
    const std::string file = result_file(entry, name);
    if (entry.unit != PositionUnit::files) return {file};
    std::vector<std::string> files;
    for (std::int64_t k = 0; k < position; ++k)
        files.push_back(frame_file_name(fs::path(file).stem().string(), k));
    return files;
}

/// Whether a branch goes on in the results of a writer: they are there, and asked for.
bool is_continued(const fs::path& from, const WriterContext& context, const WriterEntry& entry,
                  std::int64_t position) {
    const std::vector<std::string> files = files_up_to(entry, context.name, position);
    return entry.is_enabled(context) && std::all_of(files.begin(), files.end(), [&](const std::string& file) {
               std::error_code error;
               return fs::is_regular_file(from / file, error);
           });
}

}  // namespace

std::string start_of_run(const std::string& fingerprint, int stages) {
    std::string text;
    int stage = 0;
    for (Section& section : sections_of(fingerprint)) {
        if (section.heading == "[[stage]]") ++stage;
        if (is_of(section, "stage") && stage > stages) continue;
        if (is_of(section, "measured_region")) continue;
        if (is_of(section, "output"))
            std::erase_if(section.lines, [](const std::string& line) { return !shapes_state(line); });
        if (!section.heading.empty()) text += section.heading + "\n";
        for (const std::string& line : section.lines) text += line + "\n";
    }
    return text;
}

std::optional<std::string> first_difference(const std::string& start, const std::string& saved) {
    const std::vector<Section> ours = sections_of(start), theirs = sections_of(saved);
    for (std::size_t k = 0; k < std::max(ours.size(), theirs.size()); ++k) {
        if (k >= ours.size()) return "the saved run has " + described(theirs[k]) + " beyond this one's";
        if (k >= theirs.size() || ours[k].heading != theirs[k].heading)
            return described(ours[k]) + " is not in this place of the saved run";
        for (std::size_t i = 0; i < std::max(ours[k].lines.size(), theirs[k].lines.size()); ++i) {
            const std::string line = i < ours[k].lines.size() ? ours[k].lines[i] : "";
            const std::string other = i < theirs[k].lines.size() ? theirs[k].lines[i] : "";
            if (line != other) return difference(ours[k], line, other);
        }
    }
    return std::nullopt;
}

Checkpoint read_saved_state(const fs::path& path, const std::string& fingerprint, int stages) {
    if (!fs::exists(path))
        throw InputError({path.string()}, "there is no such file",
                         "the end of a stage that another run saved, by --until or save_stages");
    Checkpoint saved = read_checkpoint(path);
    if (saved.start_of_run.empty())
        throw InputError({path.string()}, "is a checkpoint from within a stage",
                         "a state saved at the end of a stage, by --until or save_stages");
    const int done = saved.results.stage + 1;
    if (done >= stages)
        throw InputError({path.string()},
                         "is the end of stage " + std::to_string(done) + ", and the run has " +
                             std::to_string(stages) + (stages == 1 ? " stage" : " stages"),
                         "a run with later stages");
    if (const auto different = first_difference(start_of_run(fingerprint, done), saved.start_of_run))
        throw InputError(
            {path.string()}, "belongs to another run: " + *different,
            "a run that differs in stages after the saved one, measured regions and output alone");
    return saved;
}

std::string saved_state_name(int stage) {
    return "stage-" + std::to_string(stage + 1) + ".saved.h5";
}

void check_earlier_results(const fs::path& from, const WriterContext& context, const Checkpoint& saved) {
    for (const WriterEntry& entry : writer_table()) {
        const auto position = saved.positions.find(entry.name);
        if (position != saved.positions.end() && is_continued(from, context, entry, position->second))
            check_digest(saved, entry, from / result_file(entry, context.name));
    }
}

void copy_earlier_results(const fs::path& from, const WriterContext& context, Checkpoint& saved) {
    for (const WriterEntry& entry : writer_table()) {
        const auto position = saved.positions.find(entry.name);
        if (position == saved.positions.end()) continue;
        if (!is_continued(from, context, entry, position->second)) {
            saved.positions.erase(position);
            continue;
        }
        for (const std::string& file : files_up_to(entry, context.name, position->second)) {
            std::error_code error;
            fs::copy_file(from / file, context.folder / file, fs::copy_options::overwrite_existing, error);
            if (error) throw OutputError(context.folder / file, "cannot be written: " + error.message());
        }
    }
}

}  // namespace rockslope::dda
