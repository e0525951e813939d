#pragma once

#include <vector>

#include "blockgen/faces/block_rings.hpp"
#include "blockgen/report/changes.hpp"

namespace rockslope::blockgen {

/// Joins blocks that are too small or too slender to a neighbour of the same material, the smallest first,
/// until none is left that can be: across the longest common boundary (SmallBlockPolicy::merge), or to all
/// that lie beyond the least of the block's joints, whose piece along the block is dropped
/// (SmallBlockPolicy::drop). Unions only: the area stays as it was, exactly.
void merge_small_blocks(FaceBlocks& faces, const NodedEdges& noded, const Subdivision& subdivision,
                        const SlopeModel& model, const std::vector<Trace>& traces, const SourceTable& table,
                        MergeReport& report);

/// Joins everything that a block encloses, but for cavities, to that block. @throws InputError at the domain
/// when the materials differ.
void fill_islands(FaceBlocks& faces, const std::vector<BlockRings>& blocks, const NodedEdges& noded,
                  const Subdivision& subdivision, const SlopeModel& model, MergeReport& report);

/// Whether a ring parts its block from other rock somewhere, rather than from a cavity all round.
bool encloses_rock(const std::vector<std::int32_t>& ring, const Subdivision& subdivision,
                   const FaceBlocks& faces);

}  // namespace rockslope::blockgen
