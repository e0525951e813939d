#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/input_error.hpp"

namespace rockslope::record {

/// A text split into lines (LF, CRLF or CRCRLF; a byte order mark is skipped), with the location of each for
/// messages.
class RecordLines {
  public:
    RecordLines(std::string_view text, std::string file_name);

    /// Number of lines.
    std::size_t size() const { return lines_.size(); }
    std::string_view operator[](std::size_t index) const { return lines_[index]; }
    /// The place of a line in the file, for messages. @param index from 0.
    SourceLocation place(std::size_t index) const { return {file_name_, static_cast<int>(index) + 1}; }
    /// The whole text unchanged, for binary formats.
    std::string_view bytes() const { return bytes_; }
    /// The name of the file, for messages.
    const std::string& file_name() const { return file_name_; }
    /// @throws InputError at a line, and at a column counted from 1 if one is given. `expected` completes
    /// "expected ...".
    [[noreturn]] void fail(std::size_t index, const std::string& what, const std::string& expected,
                           std::size_t column = 0) const;

  private:
    std::string_view bytes_;
    std::vector<std::string_view> lines_;
    std::string file_name_;
};

/// The words of a line between separators.
std::vector<std::string_view> words_of(std::string_view line, std::string_view separators = " \t");

/// The fields of a line of CSV, unquoted.
std::vector<std::string> csv_fields(std::string_view line);

/// The text without the blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

/// The finite number written in `text`, also in Fortran's notation with a leading '+' or the exponent D.
/// Nothing if the text is anything else.
std::optional<double> sample_number(std::string_view text);

/// The text in lower case (ASCII).
std::string lower_case(std::string_view text);

}  // namespace rockslope::record
