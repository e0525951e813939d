#pragma once

#include <optional>

#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The block that stands for all where a time or a frequency of the contacts is estimated before a run.
struct TypicalBlock {
    double mass = 0;  ///< kg per metre, the median of the free blocks
    double face = 0;  ///< m, the median length of an edge
};

/// The typical block of a model. @return none without free blocks.
std::optional<TypicalBlock> typical_block(const Model& model);

}  // namespace rockslope::dda
