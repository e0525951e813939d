#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/csv/csv_text.hpp"
#include "study/table/row_result.hpp"

namespace rockslope::study {

/// The rows of a study as they are now.
struct StudyRows {
    Plan plan;
    TextTable runs;  ///< runs.csv
    std::vector<RowResult> results;
};

/// How much of a row is read.
enum class Reading {
    everything,
    states  ///< no measures, but for that which tells whether the next row of an incremental study is needed
};

/// Reads all rows of a study. An incremental row is not needed where one of a smaller intensity has failed,
/// whether or not it was computed once; its intensities are then those of that row, scaled.
/// @throws InputError if the folder is no study.
StudyRows read_study(const std::filesystem::path& folder, Reading reading = Reading::everything);

/// Whether a row of an incremental study is to be computed: no row of a smaller intensity has failed. Other
/// rows always are. @param row number as in runs.csv.
/// @throws InputError if the folder is no study, or has no such row.
bool is_row_needed(const std::filesystem::path& folder, const std::string& row);

/// A row that was computed from other input than its files are now.
struct OutdatedRow {
    std::string row;      ///< number, as in runs.csv
    std::string address;  ///< of its results
    std::string files;    ///< that have changed
};

/// Compares the digests in the summaries of all rows that are done with the files as they are now, and gives
/// such a row the cause "computed from other input". @return these rows, in their order.
std::vector<OutdatedRow> mark_outdated(const std::filesystem::path& folder, StudyRows& rows);

/// The tidy table of a study, one row a run: number, factors, replicate, place in the design, status, cause,
/// measures, intensities, collapse time, address, wall time, which is the last column. Equal studies give
/// equal tables, but for the wall times.
TextTable results_table(const StudyRows& rows);

/// Headings of results_table() that are neither factors nor measures.
inline constexpr const char* const status_heading = "status";
inline constexpr const char* const cause_heading = "cause";
inline constexpr const char* const collapse_limit_heading = "collapse limit (m)";
inline constexpr const char* const wall_time_heading = "wall time (s)";

}  // namespace rockslope::study
