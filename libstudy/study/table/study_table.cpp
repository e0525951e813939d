#include "study/table/study_table.hpp"

#include "common/base/input_error.hpp"
#include "common/base/text.hpp"
#include "study/folder/study_folder.hpp"

namespace rockslope::study {

namespace fs = std::filesystem;

namespace {

std::size_t column_of(const TextTable& runs, const char* name, const fs::path& folder) {
    const auto found = runs.find(name);
    if (!found)
        throw InputError({(folder / "runs.csv").string(), 1}, std::string("has no column '") + name + "'",
                         "the table as dda-study make wrote it");
    return *found;
}

}  // namespace

StudyRows read_study(const fs::path& folder) {
    StudyRows rows;
    rows.plan = read_plan(plan_of(folder));
    rows.runs = read_csv(folder / "runs.csv");
    const std::size_t address = column_of(rows.runs, address_column, folder);
    const std::size_t cut = column_of(rows.runs, cut_column, folder);
    const std::size_t start = column_of(rows.runs, start_column, folder);
    for (const std::vector<std::string>& run : rows.runs.rows) {
        RowFolders folders;
        folders.results = folder / "results" / run[address];
        if (!run[start].empty()) folders.start = folder / "starts" / run[start];
        if (!run[cut].empty()) folders.blocks = folder / "cuts" / (run[cut] + ".blocks");
        rows.results.push_back(read_row(folders, rows.plan.measures));
    }
    return rows;
}

TextTable results_table(const StudyRows& rows) {
    TextTable table;
    std::vector<std::size_t> kept;  // columns of runs.csv
    const auto cut = rows.runs.find(cut_column), start = rows.runs.find(start_column),
               address = rows.runs.find(address_column);
    for (std::size_t k = 0; k < rows.runs.heading.size(); ++k) {
        if (k == cut || k == start || k == address) continue;
        kept.push_back(k);
        table.heading.push_back(rows.runs.heading[k]);
    }
    table.heading.insert(table.heading.end(), {status_heading, cause_heading});
    for (const Measure& measure : rows.plan.measures) table.heading.push_back(measure_heading(measure));
    for (const std::string& heading : intensity_headings()) table.heading.push_back(heading);
    table.heading.insert(table.heading.end(),
                         {"collapse time (s)", collapse_limit_heading, address_column, wall_time_heading});
    for (std::size_t k = 0; k < rows.results.size(); ++k) {
        const RowResult& result = rows.results[k];
        std::vector<std::string> fields;
        for (const std::size_t column : kept) fields.push_back(rows.runs.rows[k][column]);
        fields.push_back(state_name(result.state));
        fields.push_back(result.cause);
        for (const auto& value : result.measures) fields.push_back(number_field(value));
        for (const auto& value : result.intensities) fields.push_back(number_field(value));
        fields.push_back(number_field(result.collapse_time));
        fields.push_back(number_field(result.collapse_limit));
        fields.push_back(rows.runs.rows[k][*address]);
        fields.push_back(is_done(result.state) && result.wall_time > 0 ? shortest_text(result.wall_time)
                                                                       : "");
        table.rows.push_back(std::move(fields));
    }
    return table;
}

}  // namespace rockslope::study
