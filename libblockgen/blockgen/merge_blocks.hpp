#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "blockgen/block_rings.hpp"
#include "blockgen/changes.hpp"

namespace blockgen {

/// What was joined, for the report.
struct MergeReport {
    std::size_t small_blocks = 0;    ///< blocks below the wanted size or roundness, before merging
    std::size_t merged_blocks = 0;   ///< how many fewer blocks there are because of them
    double merged_area = 0;          ///< m2, of the small blocks that are gone
    std::size_t kept_small = 0;      ///< small blocks without a neighbour of their own material
    std::size_t filled_islands = 0;  ///< blocks that became one with the block round them
    std::vector<Change> changes;     ///< a row for each small block and each filled hole, in their order
};

/// Joins blocks that are too small or too slender to a neighbour of the same material, the smallest first,
/// until none is left that can be: across the longest common boundary (SmallPolicy::merge), or to all that
/// lie beyond the least of the block's joints, whose piece along the block is dropped (SmallPolicy::drop).
/// Unions only: the area stays as it was, exactly.
void merge_small_blocks(FaceBlocks& faces, const NodedEdges& noded, const Subdivision& subdivision,
                        const SlopeModel& model, const std::vector<Trace>& traces, const SourceTable& table,
                        MergeReport& report);

/// Joins everything that a block encloses, but for cavities, to that block. @throws InputError at the domain
/// when the materials differ.
void fill_islands(FaceBlocks& faces, const std::vector<RingBlock>& blocks, const NodedEdges& noded,
                  const Subdivision& subdivision, const SlopeModel& model, MergeReport& report);

/// Whether a ring parts its block from other rock somewhere, rather than from a cavity all round.
bool encloses_rock(const std::vector<std::int32_t>& ring, const Subdivision& subdivision,
                   const FaceBlocks& faces);

}  // namespace blockgen
