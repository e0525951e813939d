#pragma once

#include <cstdint>
#include <vector>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The model without the blocks that are marked: they keep their numbers, do not move, meet nothing and bear
/// no load; bolts and fixed points that they hold are gone. @param removed per block, or empty.
Model without_removed_blocks(const Model& model, const std::vector<std::uint8_t>& removed);

/// Takes out what the excavations up to a stage, counted from 1, remove and what is still there: blocks,
/// their contacts, their bolts. The rest keeps its stress and its contact forces, so what a block gone had
/// borne is out of balance. The stores that leave are booked as Energy::excavated. @return whether anything
/// left.
bool excavate(const Model& model, int stage, State& state);

}  // namespace rockslope::dda
