#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "common/base/input_error.hpp"

namespace rockslope::blockgen {

/// Scans a line-based text of blank-separated words once. It skips blank lines and comments, from a `#`
/// outside quotes to the end of the line. Each error is an InputError with the file, line and column of the
/// word at fault.
class RecordScanner {
  public:
    RecordScanner(std::string_view text, std::string file_name);

    /// Moves to the next line that holds a word. False at the end of the text.
    bool next_line();
    /// True when the current line has no further word.
    bool at_line_end();

    /// The next unquoted word. @throws InputError naming `expected` when the line has ended.
    std::string_view word(std::string_view expected);
    /// An unquoted or quoted name in UTF-8, with its escapes resolved.
    std::string name(std::string_view expected);
    /// A finite number.
    double number(std::string_view expected);
    /// An integer in [0, limit).
    std::int32_t index(std::string_view expected, std::int64_t limit);
    void expect_line_end();

    /// The location of the last word read.
    SourceLocation place() const;
    /// @throws InputError at the present line, always.
    [[noreturn]] void fail(const std::string& what, const std::string& expected) const;
    std::size_t size() const { return text_.size(); }

  private:
    void skip_blanks();
    char escaped_character();

    std::string_view text_;
    std::string file_name_;
    std::size_t position_ = 0;
    std::size_t line_start_ = 0;
    std::size_t next_start_ = 0;
    std::size_t line_end_ = 0;
    std::size_t word_start_ = 0;
    int line_ = 0;
};

}  // namespace rockslope::blockgen
