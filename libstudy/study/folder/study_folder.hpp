#pragma once

#include <filesystem>

#include "study/csv/csv_text.hpp"
#include "study/folder/makefile_text.hpp"

namespace rockslope::study {

/// Writes the folder of a study: runs.csv, study.json with the place of the plan, runs/NUMBER as links to the
/// results of each address, which lead nowhere before these are computed, and the Makefile last. Results that
/// are there stay, and links of earlier plans are replaced. @throws OutputError.
void write_study_folder(const PlannedStudy& study, const std::filesystem::path& folder,
                        const Programs& programs);

/// The plan of a study that was written. @throws InputError if the folder is no study.
std::filesystem::path plan_of(const std::filesystem::path& folder);

/// The target of the Makefile for a start, which is the state at the end of its last stage.
/// @throws InputError if the Makefile has none.
std::string start_target(const std::filesystem::path& folder, const std::string& address);

/// The columns of runs.csv that are not factors.
inline constexpr const char* const row_column = "row";
inline constexpr const char* const replicate_column = "replicate";
inline constexpr const char* const address_column = "address";
inline constexpr const char* const cut_column = "cut";
inline constexpr const char* const start_column = "start";
inline constexpr const char* const block_column = "design block";
inline constexpr const char* const place_column = "design place";

/// The table of the rows: number, factors, replicate, place in the design, addresses.
TextTable runs_table(const PlannedStudy& study);

}  // namespace rockslope::study
