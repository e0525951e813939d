#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace rockslope::blockgen {

/// The requested columns of a file, row by row.
struct CsvTable {
    std::size_t number_columns = 0, text_columns = 0;
    std::vector<double> numbers;     ///< finite
    std::vector<std::string> texts;  ///< empty where absent
    std::vector<int> lines;          ///< of each row in the file

    /// Number of rows.
    std::size_t row_count() const { return lines.size(); }
    /// The number in a row and a requested number column.
    double number(std::size_t row, std::size_t column) const {
        return numbers[row * number_columns + column];
    }
    /// The text in a row and a requested text column.
    std::string& text(std::size_t row, std::size_t column) { return texts[row * text_columns + column]; }
};

/// Whether the header line of a file names a column. @throws InputError when the file cannot be read.
bool csv_has_column(const std::filesystem::path& path, const std::string& name);

/// Reads comma-separated columns by the names in the header line; other columns are ignored. Without a header
/// the columns must be in the requested order. `#` starts a comment. Text columns are optional.
/// @throws InputError with file, line and column for a missing number column or a field that is not a finite
/// number.
CsvTable read_csv(const std::filesystem::path& path, const std::vector<std::string>& number_columns,
                  const std::vector<std::string>& text_columns);

}  // namespace rockslope::blockgen
