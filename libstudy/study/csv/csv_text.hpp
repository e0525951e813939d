#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rockslope::study {

/// A table of texts with a heading, as CSV files hold it (RFC 4180).
struct TextTable {
    std::vector<std::string> heading;
    std::vector<std::vector<std::string>> rows;  ///< each as long as the heading

    /// Index of the column with this heading, or with this heading before a unit, "crest" for "crest (m)".
    std::optional<std::size_t> find(std::string_view name) const;
};

/// Reads a CSV file. @throws InputError for a file that cannot be read, without a heading, with an open
/// quote, or with a row of another length.
TextTable read_csv(const std::filesystem::path& file);

/// A number as a field of a table, the shortest text that reads back the same; nothing: an empty field.
std::string number_field(const std::optional<double>& value);

/// The CSV text of a table; fields with commas, quotes or line breaks are quoted.
std::string csv_text(const TextTable& table);

}  // namespace rockslope::study
