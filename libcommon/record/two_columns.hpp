#pragma once

#include <vector>

#include "record/record_lines.hpp"
#include "record/records.hpp"

namespace rockslope::record {

/// Two columns of text, time and value, separated by blanks, tabs, commas or semicolons. "#" starts a comment
/// line, and the first line that is no comment may be a heading.
struct TwoColumns {
    std::vector<double> times;       ///< s, strictly increasing, at least two
    std::vector<double> values;      ///< as written
    std::vector<std::size_t> lines;  ///< line index of each row
    RecordDeclaration heading;       ///< quantity and unit in a heading "time (s), acceleration (m/s2)"
};

/// @throws InputError with file and line for a line that is not a sample, times that do not increase, or
/// fewer than two samples.
TwoColumns parse_two_columns(const RecordLines& lines);

}  // namespace rockslope::record
