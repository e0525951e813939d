#pragma once

#include <cstdint>
#include <span>

#include "dda/analysis/state.hpp"
#include "dda/model/model.hpp"

namespace rockslope::dda {

/// The model without its removed blocks. A removed block keeps its index, but it does not move, has no
/// contacts and carries no load. Its bolts and fixed points are deleted.
/// @param removed per block, 1 if removed; empty if no block is.
Model without_removed_blocks(const Model& model, const PerBlock<std::uint8_t>& removed);

/// Removes blocks with their contacts and bolts. The other blocks keep their stresses and contact forces, so
/// the load that a removed block carried becomes unbalanced. The stored energy of the removed parts is added
/// to Energy::excavated. @return whether any block was there.
bool remove_blocks(const Model& model, std::span<const BlockIndex> blocks, State& state);

/// Removes the blocks of all excavations up to a stage, see remove_blocks().
/// @param stage counted from 1. @return whether any block was removed.
bool excavate(const Model& model, int stage, State& state);

}  // namespace rockslope::dda
