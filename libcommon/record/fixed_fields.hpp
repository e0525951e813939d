#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/record_lines.hpp"

namespace rockslope::record {

/// A block of numbers as Fortran writes it: `per_line` fields of `width` characters, which may touch.
struct FieldLayout {
    std::size_t per_line = 0;
    std::size_t width = 0;

    std::size_t lines_of(std::size_t count) const { return (count + per_line - 1) / per_line; }
};

/// The layout that a line states, "(8F10.5)" or "(10I8)"; nothing when it states none.
std::optional<FieldLayout> stated_layout(std::string_view line);

/// The finite number in a field, blanks around it allowed, a leading '+' too; nothing when there is none.
std::optional<double> field_number(std::string_view field);

/// The whole number from 0 in a field; nothing when there is none, or it is 10^9 or more.
std::optional<std::size_t> field_count(std::string_view field);

/// Exactly `count` numbers from line `first` on.
/// @param what names the numbers in messages: "value 5 of the acceleration".
/// @throws InputError with line and column when the text ends too early, a field is no finite number, or a
/// line goes on behind its last field.
std::vector<double> fixed_fields(const RecordLines& lines, std::size_t first, std::size_t count,
                                 FieldLayout layout, const std::string& what);

/// Throws when line `index`, behind a block of `count` numbers, is a line of numbers: the count is wrong.
void expect_block_end(const RecordLines& lines, std::size_t index, std::size_t count);

/// Whether the lines from `first` on hold `count` numbers in that layout.
bool has_fixed_fields(const RecordLines& lines, std::size_t first, std::size_t count, FieldLayout layout);

/// Throws at line `index` when a header's count is no record's: fewer than two samples.
void check_count(std::size_t count, const RecordLines& lines, std::size_t index);

}  // namespace rockslope::record
