#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockslope::blockgen {

struct CsvRow {
    std::vector<double> numbers;     ///< one for each requested number column, finite
    std::vector<std::string> texts;  ///< one for each requested text column; empty when absent
    int line = 0;
};

struct CsvTable {
    std::vector<CsvRow> rows;
};

/// Reads comma-separated columns by the names in the header line; other columns are ignored. Without a header
/// the columns must be in the requested order. `#` starts a comment. Text columns are optional.
/// @throws InputError with file, line and column for a missing number column or a field that is not a finite
/// number.
CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& number_columns,
                  const std::vector<std::string>& text_columns);

}  // namespace rockslope::blockgen
