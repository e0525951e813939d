#pragma once

#include <filesystem>
#include <string>

#include "study/csv/csv_text.hpp"

namespace rockslope::study {

/// Writes a table into an SQLite database of its own, under a temporary name that is then renamed. Columns
/// have the headings as names; a field that is a number is stored as one, an empty field as NULL.
/// @throws OutputError.
void write_sqlite(const std::filesystem::path& file, const std::string& name, const TextTable& table);

}  // namespace rockslope::study
