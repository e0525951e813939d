#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockslope::blockgen {

struct CsvRow {
    std::vector<double> numbers;     ///< one for each asked-for number column, finite
    std::vector<std::string> texts;  ///< one for each optional text column; empty when absent
    int line = 0;
};

struct CsvTable {
    std::vector<CsvRow> rows;
};

/// Reads comma-separated columns by the names of the header line; further columns are ignored. Without a
/// header the columns stand in the order asked for. `#` starts a comment. @throws InputError with file, line
/// and column for a missing column or a field that is not a finite number.
CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& number_columns,
                  const std::vector<std::string>& text_columns);

}  // namespace rockslope::blockgen
