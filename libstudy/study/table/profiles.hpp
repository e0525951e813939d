#pragma once

#include <filesystem>

#include "study/csv/csv_text.hpp"
#include "study/table/study_table.hpp"

namespace rockslope::study {

/// Writes the profile that the plan asks for beside each row that is done, as profile.csv.
/// @return all of them as one tidy table: the number of the row, then the columns of its profile. Without
/// [profile] in the plan nothing is written, and the table has no heading.
/// @throws InputError for a row without frames, OutputError.
TextTable write_profiles(const std::filesystem::path& folder, const StudyRows& rows);

}  // namespace rockslope::study
