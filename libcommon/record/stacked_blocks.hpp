#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/record_lines.hpp"
#include "record/records.hpp"

namespace rockslope::record {

/// One time history in a file that stacks several: where it begins and what it is.
struct StackedBlock {
    std::size_t line = 0;  ///< index of the line that announces it
    Quantity quantity = Quantity::acceleration;
};

/// "accel", "ACCELERATION", "veloc", "displ", ...: what a heading's abbreviated word means.
std::optional<Quantity> quantity_of_abbreviation(std::string_view word);

/// The block of the declared quantity (acceleration, or the first block's where there is none) and channel:
/// the n-th block of a quantity belongs to channel n.
/// @throws InputError when there is none.
const StackedBlock& choose_block(const std::vector<StackedBlock>& blocks,
                                 const RecordDeclaration& declaration, const RecordLines& lines);

}  // namespace rockslope::record
