#include "study/table/study_table.hpp"

#include <cmath>
#include <map>

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

/// Reads rows of a study, one by one.
class Reader {
  public:
    Reader(fs::path folder, Reading reading)
        : folder_(std::move(folder)),
          plan_(read_plan(plan_of(folder_))),
          runs_(read_csv(folder_ / "runs.csv")) {
        address_ = column_of(runs_, address_column, folder_);
        cut_ = column_of(runs_, cut_column, folder_);
        start_ = column_of(runs_, start_column, folder_);
        block_ = column_of(runs_, block_column, folder_);
        replicate_ = column_of(runs_, replicate_column, folder_);
        if (plan_.design.kind == DesignKind::incremental) intensity_ = runs_.find(plan_.design.intensity);
        for (std::size_t k = 0; k < plan_.measures.size(); ++k) {
            if (intensity_ && plan_.measures[k].name == plan_.design.measure) deciding_ = k;
            if (reading == Reading::everything || deciding_ == k) wanted_.push_back(k);
        }
    }
    const Plan& plan() const { return plan_; }
    const TextTable& runs() const { return runs_; }

    RowResult read(std::size_t row) const {
        const std::vector<std::string>& run = runs_.rows[row];
        RowFolders folders;
        folders.results = folder_ / "results" / run[address_];
        if (!run[start_].empty()) folders.start = folder_ / "starts" / run[start_];
        if (!run[cut_].empty()) folders.blocks = folder_ / "cuts" / (run[cut_] + ".blocks");
        std::vector<Measure> measures;
        for (const std::size_t k : wanted_) measures.push_back(plan_.measures[k]);
        RowResult result = read_row(folders, measures);
        std::vector<std::optional<double>> values(plan_.measures.size());
        for (std::size_t k = 0; k < wanted_.size(); ++k) values[wanted_[k]] = result.measures[k];
        result.measures = std::move(values);
        return result;
    }
    /// Incremental: the record, realisation and replicate that a row belongs to.
    std::string series_of(std::size_t row) const {
        return runs_.rows[row][block_] + " " + runs_.rows[row][replicate_];
    }
    bool is_incremental() const { return intensity_.has_value(); }
    bool has_failed(const RowResult& result) const {
        if (result.state == RowState::collapsed || result.state == RowState::not_needed) return true;
        return deciding_ && result.measures[*deciding_] && *result.measures[*deciding_] > plan_.design.limit;
    }
    /// What stands for a row that is not needed, after the one of the next smaller intensity.
    RowResult not_needed_after(const RowResult& previous, std::size_t row, std::size_t previous_row) const {
        RowResult result;
        result.state = RowState::not_needed;
        result.message = "a row of a smaller intensity is beyond the limit of '" + plan_.design.measure + "'";
        result.measures.resize(plan_.measures.size());
        result.intensities = previous.intensities;
        const auto now = parse_number(runs_.rows[row][*intensity_]),
                   before = parse_number(runs_.rows[previous_row][*intensity_]);
        if (!now || !before) return result;
        const Factor& factor = plan_.factors[plan_.index_of(plan_.design.intensity)];
        const bool is_square = factor.scale && factor.scale->measure == ScaleMeasure::arias_intensity;
        scale_intensities(is_square ? std::sqrt(*now / *before) : *now / *before, result.intensities);
        return result;
    }

  private:
    fs::path folder_;
    Plan plan_;
    TextTable runs_;
    std::size_t address_ = 0, cut_ = 0, start_ = 0, block_ = 0, replicate_ = 0;
    std::optional<std::size_t> intensity_;  ///< incremental: column of the intensity
    std::optional<std::size_t> deciding_;   ///< incremental: index of the measure that tells of failure
    std::vector<std::size_t> wanted_;       ///< indices of the measures that are read
};

}  // namespace

StudyRows read_study(const fs::path& folder, Reading reading) {
    const Reader reader(folder, reading);
    StudyRows rows{reader.plan(), reader.runs(), {}};
    std::map<std::string, std::size_t> last;  // incremental: the row of the next smaller intensity, by series
    for (std::size_t k = 0; k < rows.runs.rows.size(); ++k) {
        const auto before = last.find(reader.series_of(k));
        const bool is_needed = before == last.end() || !reader.has_failed(rows.results[before->second]);
        rows.results.push_back(
            is_needed ? reader.read(k)
                      : reader.not_needed_after(rows.results[before->second], k, before->second));
        if (reader.is_incremental()) last[reader.series_of(k)] = k;
    }
    return rows;
}

bool is_row_needed(const fs::path& folder, const std::string& row) {
    const Reader reader(folder, Reading::states);
    if (!reader.is_incremental()) return true;
    const auto number = parse_number(row);
    const auto& runs = reader.runs().rows;
    const std::size_t asked = static_cast<std::size_t>(number.value_or(0)) - 1;
    if (!number || asked >= runs.size())
        throw InputError({folder.string()}, "has no row '" + row + "'",
                         "a number from 1 to " + std::to_string(runs.size()));
    for (std::size_t k = 0; k < asked; ++k)
        if (reader.series_of(k) == reader.series_of(asked) && reader.has_failed(reader.read(k))) return false;
    return true;
}

std::vector<OutdatedRow> mark_outdated(const fs::path& folder, StudyRows& rows) {
    std::vector<OutdatedRow> outdated;
    InputCheck check(folder, rows.plan.run);
    const std::size_t cut = column_of(rows.runs, cut_column, folder),
                      row = column_of(rows.runs, row_column, folder),
                      address = column_of(rows.runs, address_column, folder);
    for (std::size_t k = 0; k < rows.results.size(); ++k) {
        RowResult& result = rows.results[k];
        if (!is_done(result.state)) continue;
        const std::vector<std::string>& run = rows.runs.rows[k];
        const fs::path blocks =
            run[cut].empty() ? rows.plan.blocks : folder / "cuts" / (run[cut] + ".blocks");
        const auto files = check.different_files(result.inputs, blocks);
        if (!files) continue;
        result.cause = "computed from other input";
        outdated.push_back({run[row], run[address], *files});
    }
    return outdated;
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
