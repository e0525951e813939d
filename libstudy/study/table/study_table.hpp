#pragma once

#include <filesystem>
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

/// Reads all rows of a study. @throws InputError if the folder is no study.
StudyRows read_study(const std::filesystem::path& folder);

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
