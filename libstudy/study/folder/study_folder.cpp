#include "study/folder/study_folder.hpp"

#include <nlohmann/json.hpp>

#include "common/base/atomic_file.hpp"
#include "common/base/input_error.hpp"
#include "common/base/output_check.hpp"
#include "common/base/output_error.hpp"
#include "common/base/read_file.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

/// A TOML value as a field of a table: strings without their quotes.
std::string label_of(const std::string& value) {
    if (value.size() < 2 || value.front() != '"' || value.back() != '"') return value;
    std::string text;
    for (std::size_t k = 1; k + 1 < value.size(); ++k) {
        if (value[k] == '\\' && k + 2 < value.size()) ++k;
        text += value[k];
    }
    return text;
}

void make_link(const fs::path& link, const fs::path& target) {
    std::error_code error;
    if (fs::is_symlink(link, error) && fs::read_symlink(link, error) == target) return;
    fs::remove(link, error);
    fs::create_symlink(target, link, error);
    if (error) throw OutputError(link, "cannot be linked: " + error.message());
}

/// Removes the links beyond the last row.
void remove_old_links(const fs::path& runs, std::size_t rows) {
    std::error_code ignored;
    for (std::size_t k = rows; fs::is_symlink(runs / row_name(k), ignored); ++k)
        fs::remove(runs / row_name(k), ignored);
}

}  // namespace

TextTable runs_table(const PlannedStudy& study) {
    TextTable table;
    table.heading = {row_column};
    for (const Factor& factor : study.plan.factors) table.heading.push_back(factor.name);
    for (const char* name :
         {replicate_column, block_column, place_column, cut_column, start_column, address_column})
        table.heading.emplace_back(name);
    for (std::size_t k = 0; k < study.rows.size(); ++k) {
        const PlannedRow& planned = study.rows[k];
        std::vector<std::string> fields = {std::to_string(k + 1)};
        for (const std::string& value : planned.row.values) fields.push_back(label_of(value));
        fields.push_back(std::to_string(planned.row.replicate));
        fields.push_back(planned.row.block);
        fields.push_back(planned.row.block.empty() ? "" : std::to_string(planned.row.place));
        fields.push_back(study.plan.slope.empty() ? "" : study.cuts[planned.cut].address);
        fields.push_back(study.branch_stages > 0 ? study.starts[planned.start].address : "");
        fields.push_back(planned.address);
        table.rows.push_back(std::move(fields));
    }
    return table;
}

void write_study_folder(const PlannedStudy& study, const fs::path& folder, const Programs& programs) {
    for (const char* name : {"runs", "cuts", "starts", "results"}) make_output_folder(folder / name);
    for (const PlannedStart& start : study.starts) make_output_folder(folder / "starts" / start.address);
    write_file_atomically(folder / "runs.csv", csv_text(runs_table(study)));
    const nlohmann::ordered_json description = {
        {"plan", study.plan.file.lexically_relative(folder).string()}};
    write_file_atomically(folder / "study.json", description.dump(2) + "\n");
    for (std::size_t k = 0; k < study.rows.size(); ++k) {
        make_link(folder / "runs" / row_name(k), fs::path("../results") / study.rows[k].address);
    }
    remove_old_links(folder / "runs", study.rows.size());
    write_file_atomically(folder / "Makefile", makefile_text(study, folder, programs));
}

fs::path plan_of(const fs::path& folder) {
    const fs::path file = folder / "study.json";
    if (!fs::exists(file))
        throw InputError({folder.string()}, "is no study: there is no study.json",
                         "a folder that dda-study make wrote");
    const auto json = nlohmann::json::parse(read_text_file(file), nullptr, false);
    if (json.is_discarded() || !json.is_object() || !json.contains("plan") || !json["plan"].is_string())
        throw InputError({file.string()}, "names no plan", "the file as dda-study make wrote it");
    return fs::absolute(folder / json["plan"].get<std::string>()).lexically_normal();
}

std::string start_target(const fs::path& folder, const std::string& address) {
    const std::string makefile = read_text_file(folder / "Makefile");
    const std::string begin = "starts/" + address + "/stage-";
    const std::size_t found = makefile.find("\n" + begin);
    if (found == std::string::npos)
        throw InputError({(folder / "Makefile").string()}, "has no rule for the start " + address,
                         "the file as dda-study make wrote it");
    return makefile.substr(found + 1, makefile.find(':', found) - found - 1);
}

}  // namespace rockslope::study
