#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/record_lines.hpp"

namespace rockslope::record {

/// Layout of a block of numbers written by Fortran: `per_line` fields of `width` characters, without
/// separators.
struct FieldLayout {
    std::size_t per_line = 0;
    std::size_t width = 0;

    /// Number of lines that so many fields take.
    std::size_t lines_of(std::size_t count) const { return (count + per_line - 1) / per_line; }
};

/// The layout stated in a line as "(8F10.5)" or "(10I8)"; nothing if there is none.
std::optional<FieldLayout> stated_layout(std::string_view line);

/// The finite number in a field, with optional blanks around it and a leading '+'; nothing if there is none.
std::optional<double> field_number(std::string_view field);

/// The whole number in a field, from 0 to below 10^9; nothing if there is none.
std::optional<std::size_t> field_count(std::string_view field);

/// Reads exactly `count` numbers from line `first` on.
/// @param what name of the numbers in messages: "value 5 of the acceleration".
/// @throws InputError with line and column if the text ends too early, a field is not a finite number, or a
/// line has text after its last field.
std::vector<double> fixed_fields(const RecordLines& lines, std::size_t first, std::size_t count,
                                 FieldLayout layout, const std::string& what);

/// @throws InputError if line `index`, the first after a block of `count` numbers, contains numbers.
void expect_block_end(const RecordLines& lines, std::size_t index, std::size_t count);

/// Whether the lines from `first` on contain `count` numbers in the layout.
bool has_fixed_fields(const RecordLines& lines, std::size_t first, std::size_t count, FieldLayout layout);

/// @throws InputError at line `index` if the count of a header is less than two samples.
void check_count(std::size_t count, const RecordLines& lines, std::size_t index);

}  // namespace rockslope::record
