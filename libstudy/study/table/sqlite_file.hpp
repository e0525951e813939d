#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/csv/csv_text.hpp"

namespace rockslope::study {

/// A table of a database, by its name.
struct NamedTable {
    std::string name;
    const TextTable& table;
};

/// Writes tables into an SQLite database of their own, under a temporary name that is then renamed. Columns
/// have the headings as names; a field that is a number is stored as one, an empty field as NULL.
/// @throws OutputError.
void write_sqlite(const std::filesystem::path& file, const std::vector<NamedTable>& tables);

}  // namespace rockslope::study
