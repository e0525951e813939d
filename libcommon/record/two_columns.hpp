#pragma once

#include <vector>

#include "record/record_lines.hpp"
#include "record/records.hpp"

namespace rockslope::record {

/// Two columns of text, time and value, apart by blanks, tabs, commas or semicolons; "#" starts a comment
/// line, and the first other line may be a heading.
struct TwoColumns {
    std::vector<double> times;       ///< s, strictly increasing, at least two
    std::vector<double> values;      ///< as written
    std::vector<std::size_t> lines;  ///< index of each row's line
    RecordDeclaration heading;       ///< what "time (s), acceleration (m/s2)" says of the second column
};

/// @throws InputError with file:line for a line that is no sample, times that do not grow, fewer than two
/// samples.
TwoColumns parse_two_columns(const RecordLines& lines);

}  // namespace rockslope::record
