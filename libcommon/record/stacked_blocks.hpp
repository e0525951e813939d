#pragma once

#include <optional>
#include <vector>

#include "record/record_lines.hpp"
#include "record/records.hpp"

namespace rockslope::record {

/// One time history in a file with several.
struct StackedBlock {
    std::size_t line = 0;  ///< index of its heading line
    Quantity quantity = Quantity::acceleration;
};

/// The quantity of an abbreviated word in a heading: "accel", "ACCELERATION", "veloc", "displ", ...
std::optional<Quantity> quantity_of_abbreviation(std::string_view word);

/// The block of the declared channel and quantity. Without a declared quantity it is acceleration, or that
/// of the first block if there is no acceleration. The n-th block of a quantity belongs to channel n.
/// @throws InputError if there is no such block.
const StackedBlock& choose_block(const std::vector<StackedBlock>& blocks,
                                 const RecordDeclaration& declaration, const RecordLines& lines);

}  // namespace rockslope::record
