#pragma once

#include <vector>

#include "common/base/input_error.hpp"
#include "common/geometry/polygon.hpp"

namespace rockslope::blockgen {

/// Joins lines to closed ones where the end of one is the end of exactly one other, within a millionth of the
/// extent of all lines. Closed lines are kept. The first point of each result is repeated as its last.
/// @throws InputError at `place` where a line ends alone, or where three or more meet.
std::vector<Ring> closed_lines(std::vector<Ring> lines, const SourceLocation& place);

/// Sorts closed lines into polygons: one inside an odd number of others is an inner ring of the smallest of
/// these. @return for each polygon the outer ring first.
std::vector<std::vector<Ring>> nested_polygons(std::vector<Ring> rings);

}  // namespace rockslope::blockgen
